//! Torques and forces of the joints that are driven, where loops move the others.

use super::definition::{Definition, Property, Truth};
use super::tally::{self, Size, Tally};
use super::{constraint_jacobian, quantities};
use crate::dense::Dense;
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "actuated_inverse_dynamics",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd],
    result: quantities::FORCES,
    properties: &[Property::Mass, Property::Actuation],
    truth: Truth::Constrained(Dense::driven),
    ways: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Torques and forces τ of the joints that are driven, zero for all others, which produce q̈ against \
     gravity where the loops are held together and q, q̇ and q̈ keep them closed; N m, N. What the others need \
     comes from the loops, as far as they can give it (least squares)."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    // Without the loops, and at most as many equations as joints.
    let cubes = size.joints.pow(3);
    let parts = tally::torques(size).plus(constraint_jacobian::dense(size));
    parts.and(cubes, cubes)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.driven().into()
}
