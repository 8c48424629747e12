//! The geometric Jacobian: columns L₁ … L_N in the axes of frame 0, reference point at the end effector's origin.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally;
use crate::dense::Matrix;
use crate::expression::Term;
use crate::model::{Scene, jacobian};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "geometric_jacobian",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::SCREWS,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| {
        let tip = dense.pose(frame).0.map(|row| -row[3]);
        let back = Matrix::translation([tip[0], tip[1], tip[2]]);
        dense.columns(frame, |screw| back.carries(screw))
    }),
    algorithms: Definition::one_way,
    dense: tally::screws_elsewhere,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Geometric Jacobian of {frame}: screws L of the joints in the axes of {base} (frame 0), \
         reference point at the origin of {frame}."
    )
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.columns(&jacobian::geometric(&scene.link_path()))
}
