//! The functions that the firmware calls: the generated ones, each out of line, and a control law.
//!
//! In: joint coordinates, rates and targets. Out: torques, poses, matrices. The feedback of [`computed_torque`] is the
//! only computation here.

use core::array::from_fn;

use crate::arm::Arm;
use crate::{JOINTS, Joints, State};

/// Feedback of computed torque: critically damped at 10 rad/s.
const STIFFNESS: f32 = 100.0;
const DAMPING: f32 = 20.0;

/// M₀,tip: the rows of (R, t).
#[inline(never)]
#[must_use]
pub fn forward_kinematics(q: &Joints) -> [[f32; 4]; 3] {
    Arm.forward_kinematics(q)
}

/// The joints' screws (u; b) in the axes of the base, reference point at the tip.
#[inline(never)]
#[must_use]
pub fn geometric_jacobian(q: &Joints) -> [[f32; 6]; JOINTS] {
    Arm.geometric_jacobian(q)
}

/// The torques that hold the arm at rest against gravity \[N m\].
#[inline(never)]
#[must_use]
pub fn gravity(q: &Joints) -> Joints {
    Arm.gravity(q)
}

/// The torques that produce the accelerations `qdd` \[N m\].
#[inline(never)]
#[must_use]
pub fn inverse_dynamics(q: &Joints, qd: &Joints, qdd: &Joints) -> Joints {
    Arm.inverse_dynamics(q, qd, qdd)
}

/// The joint-space inertia [kg m²].
#[inline(never)]
#[must_use]
pub fn mass_matrix(q: &Joints) -> [Joints; JOINTS] {
    Arm.mass_matrix(q)
}

/// The accelerations that the torques `tau` produce [rad/s²].
#[inline(never)]
#[must_use]
pub fn forward_dynamics(q: &Joints, qd: &Joints, tau: &Joints) -> Joints {
    Arm.forward_dynamics(q, qd, tau)
}

/// The torques for tracking the target of `state` \[N m\].
#[inline(never)]
#[must_use]
pub fn computed_torque(state: &State) -> Joints {
    let State { q, qd, qdd, .. } = state;
    let [targets, rates] = &state.target;
    let wanted =
        from_fn(|i| qdd[i] + (DAMPING * (rates[i] - qd[i]) + STIFFNESS * (targets[i] - q[i])));
    inverse_dynamics(q, qd, &wanted)
}
