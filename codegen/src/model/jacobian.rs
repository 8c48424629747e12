//! The Jacobians: columns L₁ … L_N, one screw a body, in three frames.

use super::carry::Path;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Screw, Vector};

/// Columns in frame 0, with the pole at its origin.
pub fn spatial<'g>(path: &Path<'g>) -> List<BodyId, Screw<Term<'g>>> {
    let seen = path.outwards().into_iter();
    columns(
        path,
        seen.map(|(joint, pose)| (joint.body, joint.screw.change_frame(pose))),
    )
}

/// Columns in the axes of frame 0, with the pole at the origin of the frame at the end.
pub fn geometric<'g>(path: &Path<'g>) -> List<BodyId, Screw<Term<'g>>> {
    let seen = path.outwards_from_end().into_iter();
    columns(
        path,
        seen.map(|(joint, from_tip)| (joint.body, joint.screw.change_frame(from_tip))),
    )
}

/// Columns in the frame at the end, with the pole at its origin.
pub fn body<'g>(path: &Path<'g>) -> List<BodyId, Screw<Term<'g>>> {
    // M of each body in the frame at the end, inwards.
    let mut pose = path.end.inverse();
    let mut found = Vec::new();
    for joint in path.joints.iter().rev() {
        found.push((joint.body, joint.screw.change_frame(pose)));
        pose = pose * joint.displacement().inverse() * joint.placement.inverse();
    }
    columns(path, found.into_iter())
}

/// All columns, one for each body; those of bodies off the path are zero.
pub(super) fn columns<'g>(
    path: &Path<'g>,
    found: impl Iterator<Item = (BodyId, Screw<Term<'g>>)>,
) -> List<BodyId, Screw<Term<'g>>> {
    let graph = path.end.translation.x().graph();
    let null = Screw {
        u: Vector::zero(graph),
        b: Vector::zero(graph),
    };
    let mut columns = List::filled(null, path.count);
    for (k, screw) in found {
        columns[k] = screw;
    }
    columns
}
