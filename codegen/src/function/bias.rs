//! Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally;
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "bias",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::FORCES,
    properties: &[Property::Mass],
    truth: Truth::Value(|dense, _| dense.torques(MotionOrder::Coasting).into()),
    algorithms: Definition::one_way,
    dense: tally::torques,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint torques and forces τ at q̈ = 0: Coriolis, centrifugal and gravity terms; N m, N."
        .to_owned()
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.torques(&scene.coasting()).into()
}
