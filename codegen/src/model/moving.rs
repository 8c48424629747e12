//! W of bodies, outwards from the base, each in the frame of its joint's matrices.

use super::carry::DisplacedJoint;
use super::state::State;
use crate::expression::{LabelledBodies, Term};
use crate::matrix::Velocity;

/// W of the body beyond a joint: Wᵢₖ = Wᵢⱼ + Wⱼₖ (eq. 10).
pub fn beyond<'g>(
    outer: Velocity<Term<'g>>,
    joint: &DisplacedJoint<'g>,
    rate: Term<'g>,
) -> Velocity<Term<'g>> {
    let w = joint.motion_outboard(outer) + Velocity::of_screw(joint.screw, rate);
    let (index, frame) = joint.numbers();
    w.label(LabelledBodies::FromBase(index), frame);
    w
}

/// W of the bodies on a path from the base, in its order.
pub fn velocities<'g>(joints: &[DisplacedJoint<'g>], state: &State<'g>) -> Vec<Velocity<Term<'g>>> {
    let mut w = Velocity::zero(state.graph);
    let joints = joints.iter().map(|joint| {
        w = beyond(w, joint, state.qd(joint.body));
        w
    });
    joints.collect()
}
