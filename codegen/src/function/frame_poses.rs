//! M₀,₁ … M₀,ₙ: the poses of all requested frames.

use super::definition::{Definition, Truth};
use super::tally::{POSE, Size, Tally};
use super::{forward_kinematics, quantities};
use crate::expression::Term;
use crate::model::{Scene, pose};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "frame_poses",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::POSES,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.poses()),
    algorithms: forward_kinematics::algorithms,
    dense,
    build,
};

fn sentence(base: &str, _: &str) -> String {
    format!(
        "Poses M₀,₁ … M₀,ₙ of the requested frames in that of {base} (frame 0), in the order in which they are named; lengths in m."
    )
}

fn dense(size: Size) -> Tally {
    // Each joint moves the frames beyond it, each of which is fixed to a body.
    POSE.times(size.joints).plus(Tally::of(size.frames, 0, 0))
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let paths = scene.frames().map(|frame| scene.link_path_to(frame));
    let poses = paths.flat_map(|path| pose::forward_kinematics(&path, scene.algorithm.pose));
    poses.collect()
}
