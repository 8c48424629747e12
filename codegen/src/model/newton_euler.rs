//! Inverse dynamics by Newton and Euler: accelerations H outwards, actions Φ = skew\[H J\] inwards,
//! each in the frame of its joint's matrices.

use super::carry::{Joint, Joints};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Acceleration, Action, Vector};

/// What drives each body in a motion with the given second rates, where actions from outside are on some.
pub fn inverse_dynamics<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &List<BodyId, Term<'g>>,
    outside: &[(BodyId, Action<Term<'g>>)],
) -> List<BodyId, Term<'g>> {
    motion(joints, gravity, state, qdd, outside).tau
}

/// A motion and what it takes, each in the frame of its joint's matrices.
pub struct Motion<'g> {
    /// Of each body.
    pub motions: List<BodyId, Moving<'g>>,
    /// Φ of all that each joint carries, less the actions from outside.
    pub actions: List<BodyId, Action<Term<'g>>>,
    /// What drives each body.
    pub tau: List<BodyId, Term<'g>>,
}

/// The motion with the given second rates, where actions from outside are on some bodies.
pub fn motion<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &List<BodyId, Term<'g>>,
    outside: &[(BodyId, Action<Term<'g>>)],
) -> Motion<'g> {
    // Gravity is an acceleration of the base the other way.
    let base = Moving::still(Acceleration::linear(-gravity));
    let mut motions: List<BodyId, Moving<'g>> = List::new();
    let mut actions: List<BodyId, Action<Term<'g>>> = List::new();
    for (k, joint) in joints.numbered() {
        let outer = joint.parent.map_or(base, |parent| motions[parent]);
        let moving = beyond(outer, joint, state.qd(k), qdd[k]);
        let h = moving.h;
        let (index, frame) = joint.numbers();
        h.label(index, frame);
        motions.push(moving);
        actions.push(Action::of(h, joint.inertia));
    }
    for &(body, action) in outside {
        actions[body] = actions[body] - action;
    }
    let mut tau = List::filled(state.zero(), joints.len());
    for (k, joint) in joints.numbered().rev() {
        let action = actions[k];
        let (index, frame) = joint.numbers();
        let outer = joint.outer_frame_number();
        action.label(index, frame);
        let drive = joint.drive;
        tau[k] =
            action.along(joint.screw) + drive.armature * qdd[k] + drive.resistance(state.qd(k));
        if let Some(parent) = joint.parent {
            let carried = action
                .change_frame(joint.displacement())
                .change_frame(joint.placement);
            carried.label(index, outer);
            actions[parent] = actions[parent] + carried;
        }
    }
    Motion {
        motions,
        actions,
        tau,
    }
}

/// How a body moves, in the frame of its joint's matrices.
#[derive(Clone, Copy)]
pub struct Moving<'g> {
    /// H, by its parts.
    pub h: Acceleration<Term<'g>>,
    /// ω of what its joint hangs on, as a whole.
    pub outer: Vector<Term<'g>>,
    /// The velocity that its joint has given it so far.
    pub relative: Vector<Term<'g>>,
}

impl<'g> Moving<'g> {
    /// What no joint moves.
    pub fn still(h: Acceleration<Term<'g>>) -> Self {
        Self {
            h,
            outer: h.omega,
            relative: Vector::zero(h.a.x().graph()),
        }
    }
}

/// The motion of the body beyond a joint, where the joint's matrices are: Hᵢₖ = Hᵢⱼ + Hⱼₖ + 2 Wᵢⱼ Wⱼₖ
/// (eq. 11) by its parts, of which Hⱼₖ's own ω × v is half a Coriolis term more.
///
/// Of a joint with several velocities, Wⱼₖ = Σ L q̇ is seen in the frame of its last body, where all L
/// are constant: Hⱼₖ = Σ L q̈ + Wⱼₖ², of which each L adds what it has in common with those before it.
pub fn beyond<'g>(
    outer: Moving<'g>,
    joint: &Joint<'g>,
    rate: Term<'g>,
    second: Term<'g>,
) -> Moving<'g> {
    let (carried, offset) = seen(outer.h, joint);
    let (u, b) = (joint.screw.u, joint.screw.b);
    let (turning, sliding) = (u * rate, b * rate);
    let (base, relative, coriolis) = if joint.taken {
        let before = carried.omega + outer.outer + turning;
        let coriolis = turning.cross(outer.relative) + before.cross(sliding);
        (outer.outer, outer.relative + sliding, coriolis)
    } else {
        let half = rate.graph().constant(0.5);
        let coriolis = (carried.omega + turning * half).cross(b * (rate + rate));
        (carried.omega, sliding, coriolis)
    };
    let h = Acceleration {
        omega: carried.omega + turning,
        omega_dot: carried.omega_dot + u * second + base.cross(turning),
        a: carried.point(offset) + b * second + coriolis,
    };
    Moving {
        h,
        outer: base,
        relative,
    }
}

/// H of the body that a joint hangs on, in the axes of the joint's matrices, and where from its pole theirs is.
pub fn seen<'g>(
    outer: Acceleration<Term<'g>>,
    joint: &Joint<'g>,
) -> (Acceleration<Term<'g>>, Vector<Term<'g>>) {
    let placed = outer
        .move_pole(joint.placement.translation)
        .rotate(joint.placement.rotation.transposed());
    match joint.posture {
        Some(posture) => {
            let moved = placed.move_pole(posture.translation);
            let turned = moved.rotate(posture.rotation.transposed());
            (turned, Vector::zero(joint.slide.graph()))
        }
        None => (placed.rotate(joint.turn().transposed()), joint.offset()),
    }
}
