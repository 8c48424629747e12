//! The kinematic Hessian, contracted: ∂(Jᵗ Φ)/∂q of the geometric Jacobian J for a wrench Φ.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{self, Size, Tally};
use crate::dense::Dense;
use crate::expression::Term;
use crate::model::{Scene, jacobian_derivative};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_kinematics_hessian",
    sentence,
    arguments: &[Variable::Q, Variable::Wrench],
    result: quantities::STIFFNESS,
    properties: &[Property::Frame],
    truth: Truth::Value(Dense::forward_kinematics_hessian),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Kinematic Hessian of {frame}, contracted: ∂(Jᵗ Φ)/∂q of the geometric Jacobian J for a constant wrench Φ at the \
         origin of {frame}, in the axes of {base} (frame 0); a row for each torque or force of Jᵗ Φ; N m, N, N/m. \
         With a couple of zero it is symmetric, the second derivative of fᵗ p for the force f and the position p."
    )
}

fn dense(size: Size) -> Tally {
    // The rates of all columns at a unit velocity of each joint, and their products with the wrench.
    let derivative = tally::screw_rates_elsewhere(size).times(size.path);
    let squares = size.path.pow(2);
    derivative.and(6 * squares, 5 * squares)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let wrench = scene.state.weights_of_twist();
    let powers = jacobian_derivative::contracted(&scene.link_path(), wrench);
    scene.by_velocities(powers).into()
}
