//! The Jacobian in the axes of frame 0: columns L₁ … L_N, pole at the origin of the tip.

use super::dense;
use super::table::Definition;
use super::{Argument, Shape, units};
use crate::expression::Term;
use crate::model::{Scene, jacobian};

pub(super) const DEFINITION: Definition = Definition {
    name: "geometric_jacobian",
    sentence,
    arguments: &[Argument::Q],
    shape: Shape::Screws,
    units: units::screws,
    solves: false,
    ways: Definition::one_way,
    dense: dense::screws_elsewhere,
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
