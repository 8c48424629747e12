//! The body Jacobian: columns L₁ … L_N in the end effector's frame, reference point at its origin.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally;
use crate::expression::Term;
use crate::model::{Scene, jacobian};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "body_jacobian",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::SCREWS,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| {
        let back = dense.pose(frame).inverse();
        dense.columns(frame, |screw| back.carries(screw))
    }),
    algorithms: Definition::one_way,
    dense: tally::screws_elsewhere,
    build,
};

fn sentence(_: &str, frame: &str) -> String {
    format!(
        "Body Jacobian of {frame}: screws L of the joints in the axes of {frame}, reference point \
         at its origin."
    )
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.columns(&jacobian::body(&scene.path()))
}
