//! The Jacobian in the frame of the tip: columns L₁ … L_N, pole at its origin.

use super::dense;
use super::table::Definition;
use super::{Argument, Shape, units};
use crate::expression::Term;
use crate::formulation::Frame;
use crate::model::{Scene, base_frame, jacobian};

pub(super) const DEFINITION: Definition = Definition {
    name: "body_jacobian",
    sentence,
    arguments: &[Argument::Q],
    shape: Shape::Screws,
    units: units::screws,
    solves: false,
    ways: Definition::one_way,
    dense: dense::screws_elsewhere,
    build,
};

fn sentence(_: &str, frame: &str) -> String {
    format!(
        "Body Jacobian of {frame}: screws L of the joints in the axes of {frame}, pole at its \
         origin."
    )
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    match scene.way.frame {
        Frame::Link => jacobian::body(&scene.path()),
        Frame::Base => base_frame::body_jacobian(&scene.path()),
    }
}
