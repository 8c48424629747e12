//! Joint torques and forces that produce q̈.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally;
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "inverse_dynamics",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd],
    result: quantities::FORCES,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Value(|dense, _| dense.driving_torques().into()),
    algorithms: Definition::one_way,
    dense: tally::torques,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint torques and forces τ that produce q̈ against gravity; N m, N.".to_owned()
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.driving(&scene.qdd()).into()
}
