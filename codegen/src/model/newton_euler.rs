//! Inverse dynamics by Newton and Euler (RNEA): accelerations H outwards, wrenches Φ = skew\[H J\] inwards, each in the
//! frame of its joint's matrices.

use super::carry::{DisplacedJoint, Joints};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Acceleration, Action, Vector};

/// τ of each body in a motion with the given q̈, with external wrenches on some.
pub fn inverse_dynamics<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &List<BodyId, Term<'g>>,
    external: &[(BodyId, Action<Term<'g>>)],
) -> List<BodyId, Term<'g>> {
    motion(joints, gravity, state, qdd, external).tau
}

/// A motion with its wrenches and torques, each in the frame of its joint's matrices.
pub struct Dynamics<'g> {
    /// The motion of each body.
    pub motions: List<BodyId, BodyMotion<'g>>,
    /// Φ of all bodies that each joint carries, less the external wrenches.
    pub actions: List<BodyId, Action<Term<'g>>>,
    /// τ of each body.
    pub tau: List<BodyId, Term<'g>>,
}

/// The motion with the given q̈, with external wrenches on some bodies.
pub fn motion<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &List<BodyId, Term<'g>>,
    external: &[(BodyId, Action<Term<'g>>)],
) -> Dynamics<'g> {
    // Gravity is replaced by the opposite acceleration of the base.
    let base = BodyMotion::still(Acceleration::linear(-gravity));
    let mut motions: List<BodyId, BodyMotion<'g>> = List::new();
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
    for &(body, action) in external {
        actions[body] = actions[body] - action;
    }
    let mut tau = List::filled(state.zero(), joints.len());
    for (k, joint) in joints.numbered().rev() {
        let action = actions[k];
        let (index, frame) = joint.numbers();
        let outer = joint.outer_frame_number();
        action.label(index, frame);
        let actuator = joint.actuator;
        tau[k] = action.along(joint.screw)
            + actuator.armature * qdd[k]
            + actuator.resistance(state.qd(k));
        if let Some(parent) = joint.parent {
            let carried = joint.action_inboard(action);
            carried.label(index, outer);
            actions[parent] = actions[parent] + carried;
        }
    }
    Dynamics {
        motions,
        actions,
        tau,
    }
}

/// The motion of a body, in the frame of its joint's matrices.
#[derive(Clone, Copy)]
pub struct BodyMotion<'g> {
    /// H.
    pub h: Acceleration<Term<'g>>,
    /// ω of its joint's parent body.
    pub outer: Vector<Term<'g>>,
    /// The velocity that its joint has added so far.
    pub relative: Vector<Term<'g>>,
}

impl<'g> BodyMotion<'g> {
    /// The motion of a body that no joint moves.
    pub fn still(h: Acceleration<Term<'g>>) -> Self {
        Self {
            h,
            outer: h.omega,
            relative: Vector::zero(h.a.x().graph()),
        }
    }
}

/// The motion of the body beyond a joint, in the frame of the joint's matrices: Hᵢₖ = Hᵢⱼ + Hⱼₖ + 2 Wᵢⱼ Wⱼₖ (eq. 11),
/// where the ω × v of Hⱼₖ itself adds half a Coriolis term.
///
/// For a joint with several velocities, Wⱼₖ = Σ L q̇ is in the frame of its last body, where all L are constant:
/// Hⱼₖ = Σ L q̈ + Wⱼₖ², to which each L adds its products with those before it.
pub fn beyond<'g>(
    outer: BodyMotion<'g>,
    joint: &DisplacedJoint<'g>,
    rate: Term<'g>,
    second: Term<'g>,
) -> BodyMotion<'g> {
    let (carried, offset) = seen(outer.h, joint);
    let (u, b) = (joint.screw.u, joint.screw.b);
    let (angular, linear) = (u * rate, b * rate);
    let (base, relative, coriolis) = if joint.taken {
        let before = carried.omega + outer.outer + angular;
        let coriolis = angular.cross(outer.relative) + before.cross(linear);
        (outer.outer, outer.relative + linear, coriolis)
    } else {
        let half = rate.graph().constant(0.5);
        let coriolis = (carried.omega + angular * half).cross(b * (rate + rate));
        (carried.omega, linear, coriolis)
    };
    let h = Acceleration {
        omega: carried.omega + angular,
        omega_dot: carried.omega_dot + u * second + base.cross(angular),
        a: carried.point(offset) + b * second + coriolis,
    };
    BodyMotion {
        h,
        outer: base,
        relative,
    }
}

/// H of a joint's parent body, in the axes of the joint's matrices, and the offset from its pole to theirs.
pub fn seen<'g>(
    outer: Acceleration<Term<'g>>,
    joint: &DisplacedJoint<'g>,
) -> (Acceleration<Term<'g>>, Vector<Term<'g>>) {
    let placed = outer
        .move_pole(joint.placement.translation)
        .rotate(joint.placement.rotation.transposed());
    match joint.displacement {
        Some(displacement) => {
            let moved = placed.move_pole(displacement.translation);
            let rotated = moved.rotate(displacement.rotation.transposed());
            (rotated, Vector::zero(joint.translation.graph()))
        }
        None => (placed.rotate(joint.turn().transposed()), joint.offset()),
    }
}
