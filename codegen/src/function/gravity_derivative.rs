//! The derivative of gravity torques by q.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "gravity_derivative",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::STIFFNESS,
    properties: &[Property::Mass],
    truth: Truth::Value(|dense, _| dense.gravity_derivative().into()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Derivative ∂τ/∂q of the joint torques and forces τ that hold the robot at rest, a row for each force; \
     N m, N, N/m."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    // For each joint a composite J, for each entry −Tr(H_g J Lᵢᵗ Lₘᵗ).
    let joint = KINEMATIC.plus(INERTIA).plus(Tally::of(2, 0, 1));
    let entry = Tally::default().and(16, 15);
    let entries = entry.times(size.joints * (size.joints + 1) / 2);
    joint.times(size.joints).plus(entries)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.gravity_derivative().into()
}
