//! M₀,ₕ, the pose of a frame.
//!
//! In: the path from the base to the frame. Out: its pose, passed inwards by columns, or outwards by matrices.

use super::algorithm::Carried;
use super::carry::Path;
use crate::expression::{Block, LabelledBodies, Numeral, Term};
use crate::matrix::{Pose, Rotation, Vector};

/// M of the frame at the end of a path, by rows.
pub fn forward_kinematics<'g>(path: &Path<'g>, carried: Carried) -> Vec<Term<'g>> {
    let pose = match carried {
        Carried::Inwards { by_product } => inwards(path, by_product),
        Carried::Outwards => path.pose(),
    };
    pose.entries().to_vec()
}

fn inwards<'g>(path: &Path<'g>, by_product: Option<usize>) -> Pose<Term<'g>> {
    let mut columns: [Vector<Term<'g>>; 3] = std::array::from_fn(|k| path.end.rotation.column(k));
    let mut origin = path.end.translation;
    for joint in path.joints.iter().rev() {
        for (k, column) in columns.iter_mut().enumerate() {
            if by_product != Some(k) {
                *column = joint.vector_inboard(*column);
            }
        }
        origin = joint.point_inboard(origin);
        label(joint.outer_frame_number(), columns, origin, by_product);
    }
    if let Some(k) = by_product {
        columns[k] = columns[(k + 1) % 3].cross(columns[(k + 2) % 3]);
    }
    Pose {
        rotation: Rotation::from_columns(columns),
        translation: origin,
    }
}

/// Labels the entries of M of the end frame in frame `index`, that of the last joint included.
fn label(
    index: Numeral,
    columns: [Vector<Term<'_>>; 3],
    origin: Vector<Term<'_>>,
    by_product: Option<usize>,
) {
    for (k, column) in columns.into_iter().enumerate() {
        if by_product != Some(k) {
            column.label(Block::Axis(k).of(LabelledBodies::TipFrom(index)));
        }
    }
    origin.label(Block::Origin.of(LabelledBodies::TipFrom(index)));
}
