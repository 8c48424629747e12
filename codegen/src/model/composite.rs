//! The mass matrix from composite pseudo-inertias: column i is the action skew\[Lᵢ J\] of everything
//! outboard of joint i, seen by the joints inboard of it.

use super::carry::Joint;
use super::state::State;
use crate::expression::Term;
use crate::matrix::Action;

/// The mass matrix, row by row.
pub fn mass_matrix<'g>(joints: &[Joint<'g>], state: &State<'g>) -> Vec<Term<'g>> {
    let count = joints.len();
    let mut composites: Vec<_> = joints.iter().map(|joint| joint.inertia).collect();
    let mut entries = vec![state.zero(); count * count];
    for column in (0..count).rev() {
        let (index, frame) = (column + 1, joints[column].frame);
        composites[column].label(|| format!("j_{index}_in_{frame}_"));
        let mut action = Action::of_screw(joints[column].screw, composites[column]);
        let mut at = column;
        loop {
            let mut seen = action.along(joints[at].screw);
            if at == column {
                seen = seen + joints[at].drive.armature;
            }
            entries[at * count + column] = seen;
            entries[column * count + at] = seen;
            let Some(parent) = joints[at].parent else {
                break;
            };
            action = action
                .change_frame(joints[at].displacement())
                .change_frame(joints[at].placement);
            let frame = joints[at].outer_frame;
            action.label(|| format!("phi_{index}_in_{frame}_"));
            at = parent;
        }
        if let Some(parent) = joints[column].parent {
            composites[parent] =
                composites[parent] + joints[column].inertia_inboard(composites[column]);
        }
    }
    entries
}
