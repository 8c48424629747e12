//! The Jacobian in the axes of frame 0: columns L₁ … L_N, pole at the origin of the tip.

use super::definition::Definition;
use super::quantities;
use super::tally;
use crate::expression::Term;
use crate::model::{Scene, jacobian};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "geometric_jacobian",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::SCREWS,
    of_a_frame: true,
    solves: false,
    ways: Definition::one_way,
    dense: tally::screws_elsewhere,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Geometric Jacobian of {frame}: screws L of the joints in the axes of {base} (frame 0), \
         pole at the origin of {frame}."
    )
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    jacobian::geometric(&scene.path())
}
