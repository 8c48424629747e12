//! The kinematic Hessian in full: ∂L₁/∂q … ∂L_N/∂q of the geometric Jacobian, by each coordinate.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{self, Size, Tally};
use crate::dense::Dense;
use crate::expression::Term;
use crate::model::{Scene, jacobian_derivative};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "jacobian_derivative",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::SCREW_DERIVATIVES,
    properties: &[Property::Frame],
    truth: Truth::Value(Dense::jacobian_derivative),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Derivatives of the geometric Jacobian of {frame} by each coordinate, or along each velocity of a joint with a \
         quaternion: ∂L/∂q of the joints in the axes of {base} (frame 0), reference point at the moving origin of {frame}."
    )
}

fn dense(size: Size) -> Tally {
    // The rates of all columns at a unit velocity of each joint.
    tally::screw_rates_elsewhere(size).times(size.path)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let entries = jacobian_derivative::geometric(&scene.link_path());
    let entries = entries.map(|matrix| Vec::from(scene.by_velocities(matrix)));
    let screws = 0..entries[0].len();
    screws
        .flat_map(|place| entries.each_ref().map(|entry| entry[place]))
        .collect()
}
