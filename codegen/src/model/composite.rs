//! The mass matrix from composite pseudo-inertias (composite-rigid-body algorithm): column i is the wrench skew\[Lᵢ J\]
//! of all bodies outboard of joint i, along the screws of the joints inboard of it.

use super::carry::Joints;
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::Square;
use crate::matrix::Action;

/// The mass matrix, by rows.
pub fn mass_matrix<'g>(joints: &Joints<'g>, state: &State<'g>) -> Square<BodyId, Term<'g>> {
    let mut composites = joints.map(|joint| joint.inertia);
    let mut entries = Square::filled(state.zero(), joints.len());
    for column in joints.ids().rev() {
        let (index, frame) = joints[column].numbers();
        composites[column].label(index, frame);
        let mut action = Action::of_screw(joints[column].screw, composites[column]);
        let mut at = column;
        loop {
            let mut entry = action.along(joints[at].screw);
            if at == column {
                entry = entry + joints[at].actuator.armature;
            }
            entries.set_both((at, column), entry);
            let Some(parent) = joints[at].parent else {
                break;
            };
            action = joints[at].action_inboard(action);
            let frame = joints[at].outer_frame_number();
            action.label(index, frame);
            at = parent;
        }
        if let Some(parent) = joints[column].parent {
            composites[parent] =
                composites[parent] + joints[column].inertia_inboard(composites[column]);
        }
    }
    entries
}
