//! Inverse dynamics by Newton and Euler: accelerations H outwards, actions Φ = skew\[H J\] inwards,
//! each in the frame of its joint's matrices.

use super::carry::Joint;
use super::state::State;
use crate::expression::Term;
use crate::matrix::{Acceleration, Action, Vector};

/// τ of a motion with the given q̈, one entry a joint.
pub fn inverse_dynamics<'g>(
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &[Term<'g>],
) -> Vec<Term<'g>> {
    let count = joints.len();
    // Gravity is an acceleration of the base the other way.
    let base = Acceleration::linear(-gravity);
    let mut accelerations: Vec<Acceleration<Term<'g>>> = Vec::with_capacity(count);
    let mut actions: Vec<Action<Term<'g>>> = Vec::with_capacity(count);
    for (k, joint) in joints.iter().enumerate() {
        let outer = joint.parent.map_or(base, |parent| accelerations[parent]);
        let h = beyond(outer, joint, state.qd(k), qdd[k]);
        let (index, frame) = (k + 1, joint.frame);
        h.omega.label(|| format!("w_0_{index}_in_{frame}_"));
        h.omega_dot.label(|| format!("wd_0_{index}_in_{frame}_"));
        h.a.label(|| format!("h_0_{index}_in_{frame}_"));
        accelerations.push(h);
        actions.push(Action::of(h, joint.inertia));
    }
    let mut tau = vec![state.zero(); count];
    for k in (0..count).rev() {
        let (joint, action) = (&joints[k], actions[k]);
        let (index, frame, outer) = (k + 1, joint.frame, joint.outer_frame);
        action.label(|| format!("phi_{index}_in_{frame}_"));
        tau[k] = action.along(joint.screw);
        if let Some(parent) = joint.parent {
            let carried = action
                .change_frame(joint.displacement())
                .change_frame(joint.placement);
            carried.label(|| format!("phi_{index}_in_{outer}_"));
            actions[parent] = actions[parent] + carried;
        }
    }
    tau
}

/// H of the body beyond a joint, where the joint's matrices are: Hᵢₖ = Hᵢⱼ + Hⱼₖ + 2 Wᵢⱼ Wⱼₖ (eq. 11)
/// by its parts, of which Hⱼₖ's own ω × v is half a Coriolis term more.
pub fn beyond<'g>(
    outer: Acceleration<Term<'g>>,
    joint: &Joint<'g>,
    rate: Term<'g>,
    second: Term<'g>,
) -> Acceleration<Term<'g>> {
    let carried = outer
        .move_pole(joint.placement.translation)
        .rotate(joint.placement.rotation.transposed())
        .rotate(joint.turn().transposed());
    let (u, b) = (joint.screw.u, joint.screw.b);
    let half = rate.graph().constant(0.5);
    let coriolis = (carried.omega + u * rate * half).cross(b * (rate + rate));
    Acceleration {
        omega: carried.omega + u * rate,
        omega_dot: carried.omega_dot + u * second + carried.omega.cross(u * rate),
        a: carried.point(joint.offset()) + b * second + coriolis,
    }
}
