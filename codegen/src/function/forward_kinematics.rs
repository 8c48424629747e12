//! M₀,tip: the pose of a frame.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{POSE, Size, Tally};
use crate::expression::Term;
use crate::model::{Algorithm, Carried, Scene, pose};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_kinematics",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::POSE,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| dense.pose(frame).upper()),
    algorithms,
    dense,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!("Pose M₀,ₜ of the frame of {frame} in that of {base} (frame 0); lengths in m.")
}

fn dense(size: Size) -> Tally {
    POSE.times(size.path).plus(Tally::of(1, 0, 0))
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    pose::forward_kinematics(&scene.link_path(), scene.algorithm.pose)
}

/// Any column of the rotation is the cross product of the two others. From the base outwards, a pose shares work with
/// Jacobians, and with poses of other frames.
pub(super) fn algorithms() -> Vec<Algorithm> {
    let carried = (0..3).map(|column| Carried::Inwards {
        by_product: Some(column),
    });
    let carried = carried.chain([Carried::Outwards]);
    let others = carried.map(|pose| Algorithm {
        pose,
        ..Algorithm::PLAIN
    });
    [Algorithm::PLAIN].into_iter().chain(others).collect()
}
