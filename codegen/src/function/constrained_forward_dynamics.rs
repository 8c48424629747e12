//! Forward dynamics of a robot with loops: joint accelerations and constraint forces.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{Size, Tally};
use super::{constraint_bias, constraint_jacobian, forward_dynamics};
use crate::dense::Dense;
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "constrained_forward_dynamics",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Tau],
    result: quantities::CONSTRAINED_MOTION,
    properties: &[Property::Mass],
    truth: Truth::Constrained(Dense::constrained),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint accelerations q̈ that τ produces against gravity with closed loops, and the constraint forces \
     (multipliers) λ: M q̈ + h = τ + Jᵗ λ and J q̈ + γ = 0, with J and γ of constraint_jacobian and \
     constraint_bias; rad/s², m/s² and N, N m. λ are forces on B along the axes of A, torques for products of \
     axes, and the force along a rod, positive in compression. A residual that depends on those before it within \
     about nine digits (five in f32) is left out, and its multiplier is zero."
        .to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    // Forward dynamics without loops, Jacobian and bias, and at most as many residuals as joints.
    let cubes = size.joints.pow(3);
    let parts = forward_dynamics::dense(size).plus(constraint_jacobian::dense(size));
    parts.plus(constraint_bias::dense(size)).and(cubes, cubes)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.constrained().concat()
}
