//! Joint torques and forces that produce q̈.

use super::dense;
use super::table::Definition;
use super::{Argument, Shape, units};
use crate::expression::Term;
use crate::model::Scene;

pub(super) const DEFINITION: Definition = Definition {
    name: "inverse_dynamics",
    sentence,
    arguments: &[Argument::Q, Argument::Qd, Argument::Qdd],
    shape: Shape::Vector,
    units: units::forces,
    solves: false,
    ways: Definition::one_way,
    dense: dense::torques,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint torques and forces τ that produce q̈ against gravity; N m, N.".to_owned()
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.torques(&scene.state.qdds(scene.count()))
}
