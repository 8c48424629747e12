//! Regrouping: inertia that has no effect on a joint moves to the inner side of the joint.
//!
//! In: the bodies with their frames. Out: the same bodies with as many parameters zero as the joint between two bodies
//! allows (structure rule 4), which changes no torque. It works on scalars of 106 bits, which are rounded once, when
//! they become literals. The result is not a physical inertia: functions that need one take the bodies without
//! regrouping.

use super::Bodies;
use crate::chain::BodyId;

/// Moves the inertia of body `k` that its joint allows to the parent. Call it from the last body to the first.
pub fn pass_inboard(bodies: &mut Bodies<'_>, k: BodyId) {
    let body = bodies.bodies[k];
    let passes = body.motion.invariant(body.inertia);
    bodies.bodies[k].inertia = body.inertia - passes;
    let inboard = match body.parent {
        Some(parent) => &mut bodies.bodies[parent].inertia,
        None => &mut bodies.base,
    };
    *inboard = *inboard + passes.change_frame(body.placement);
}
