//! Momentum Γ of all bodies that joints move, its derivative by each velocity, and Γ̇ at q̈ = 0.
//!
//! In: the joints and bodies, and q̇. Out: the sum in frame 0. Γ has the blocks of Φ (γ in place of c, ρ in place of f)
//! and the same change of frame, so that one type is used for both.

use super::carry::{self, Joints};
use super::newton_euler::{BodyMotion, beyond};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Acceleration, Action, Inertia, Pose, Vector};

/// Γ of all bodies, with the pole at the origin of frame 0: skew\[L J\] q̇ of the bodies that each joint carries.
pub fn momentum<'g>(joints: &Joints<'g>, state: &State<'g>) -> Action<Term<'g>> {
    let moving = joints.iter().zip(composites(joints));
    let each = moving.map(|(joint, composite)| {
        let Action { c, f } = Action::of_screw(joint.screw, composite);
        let rate = state.qd(joint.body);
        Action {
            c: c * rate,
            f: f * rate,
        }
    });
    sum(joints, each.collect(), state)
}

/// Γ̇ at q̈ = 0: Φ = skew\[H J\] of all bodies without gravity, with the pole at the origin of frame 0.
pub fn bias<'g>(joints: &Joints<'g>, state: &State<'g>) -> Action<Term<'g>> {
    let rest = BodyMotion::still(Acceleration::linear(Vector::zero(state.graph)));
    let mut motions: List<BodyId, BodyMotion<'g>> = List::new();
    let mut each = List::new();
    for joint in joints {
        let outer = joint.parent.map_or(rest, |parent| motions[parent]);
        let moving = beyond(outer, joint, state.qd(joint.body), state.zero());
        let h = moving.h;
        let (index, frame) = joint.numbers();
        h.label(index, frame);
        motions.push(moving);
        each.push(Action::of(h, joint.inertia));
    }
    sum(joints, each, state)
}

/// Γ at a unit velocity of each body, skew\[L J\] of all that it carries, with the pole at a point of frame 0.
pub fn columns<'g>(joints: &Joints<'g>, pole: Vector<Term<'g>>) -> List<BodyId, Action<Term<'g>>> {
    let placed = carry::placed(joints).into_iter().zip(composites(joints));
    let columns = placed.map(|((joint, pose), composite)| {
        let from_pole = Pose {
            translation: pose.translation - pole,
            ..pose
        };
        Action::of_screw(joint.screw, composite).change_frame(from_pole)
    });
    columns.collect()
}

/// J of each body with all that it carries.
fn composites<'g>(joints: &Joints<'g>) -> List<BodyId, Inertia<Term<'g>>> {
    let mut composites = joints.map(|joint| joint.inertia);
    for (k, joint) in joints.numbered().rev() {
        let (index, frame) = joint.numbers();
        composites[k].label(index, frame);
        if let Some(parent) = joint.parent {
            composites[parent] = composites[parent] + joint.inertia_inboard(composites[k]);
        }
    }
    composites
}

/// Values of each body, moved to the base and summed.
fn sum<'g>(
    joints: &Joints<'g>,
    mut each: List<BodyId, Action<Term<'g>>>,
    state: &State<'g>,
) -> Action<Term<'g>> {
    let nothing = Vector::zero(state.graph);
    let mut all = Action {
        c: nothing,
        f: nothing,
    };
    for (k, joint) in joints.numbered().rev() {
        let carried = joint.action_inboard(each[k]);
        match joint.parent {
            Some(parent) => each[parent] = each[parent] + carried,
            None => all = all + carried,
        }
    }
    all
}
