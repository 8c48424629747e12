//! The Jacobians: columns L₁ … L_N, one screw a joint, in three frames.

use super::carry::Path;
use crate::expression::Term;
use crate::matrix::{Pose, Screw, Vector};

/// Columns in frame 0, pole at its origin.
pub fn spatial<'g>(path: &Path<'g>) -> Vec<Term<'g>> {
    columns(
        path,
        outwards(path)
            .into_iter()
            .map(|(k, screw, pose)| (k, screw.change_frame(pose))),
    )
}

/// Columns in the axes of frame 0, pole at the origin of the frame at the end.
pub fn geometric<'g>(path: &Path<'g>) -> Vec<Term<'g>> {
    let steps = outwards(path);
    let end = steps.last().map_or(path.end.translation, |(_, _, pose)| {
        pose.point(path.end.translation)
    });
    let columns_ = steps.into_iter().map(|(k, screw, pose)| {
        let seen = Pose {
            translation: pose.translation - end,
            ..pose
        };
        (k, screw.change_frame(seen))
    });
    columns(path, columns_.collect::<Vec<_>>().into_iter())
}

/// Columns in the frame at the end, pole at its origin.
pub fn body<'g>(path: &Path<'g>) -> Vec<Term<'g>> {
    // M from the end to each body, inwards.
    let mut pose = path.end.inverse();
    let mut found = Vec::new();
    for joint in path.joints.iter().rev() {
        found.push((joint.index, joint.screw.change_frame(pose)));
        pose = pose * joint.displacement().inverse() * joint.placement.inverse();
    }
    columns(path, found.into_iter())
}

/// For each joint on the path: its index, L in its body's frame, M₀ of that frame.
fn outwards<'g>(path: &Path<'g>) -> Vec<(usize, Screw<Term<'g>>, Pose<Term<'g>>)> {
    let mut pose = Pose::identity(path.end.translation.x().graph());
    (path.joints.iter())
        .map(|joint| {
            pose = pose * joint.placement * joint.displacement();
            let index = joint.index + 1;
            pose.translation.label(|| format!("m_0_{index}_t"));
            for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
                pose.rotation
                    .column(k)
                    .label(|| format!("m_0_{index}_{axis}"));
            }
            (joint.index, joint.screw, pose)
        })
        .collect()
}

/// All columns; those of joints off the path are null.
fn columns<'g>(
    path: &Path<'g>,
    found: impl Iterator<Item = (usize, Screw<Term<'g>>)>,
) -> Vec<Term<'g>> {
    let graph = path.end.translation.x().graph();
    let null = Screw {
        u: Vector::zero(graph),
        b: Vector::zero(graph),
    };
    let mut columns = vec![null; path.count];
    for (k, screw) in found {
        columns[k] = screw;
    }
    columns.into_iter().flat_map(Screw::entries).collect()
}
