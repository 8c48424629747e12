//! Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms.

use super::dense;
use super::table::Definition;
use super::{Argument, Shape, units};
use crate::expression::Term;
use crate::model::Scene;

pub(super) const DEFINITION: Definition = Definition {
    name: "bias",
    sentence,
    arguments: &[Argument::Q, Argument::Qd],
    shape: Shape::Vector,
    units: units::forces,
    solves: false,
    ways: Definition::one_way,
    dense: dense::torques,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint torques and forces τ at q̈ = 0: Coriolis, centrifugal and gravity terms; N m, N."
        .to_owned()
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.torques(&vec![scene.state.zero(); scene.count()])
}
