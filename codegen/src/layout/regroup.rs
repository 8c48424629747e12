//! Base parameters: mass that no joint can feel goes to the other side of it.
//!
//! In: the bodies with their frames. Out: the same bodies with as many parameters zero as the joint
//! between two bodies allows (structure rule 4), which changes no torque. It works on scalars of 106 bits, which
//! are rounded once, when they become literals. The result is not a physical inertia: a function
//! that needs one takes the bodies as they were before.

use super::Bodies;
use crate::chain::Motion;
use crate::expression::Term;
use crate::matrix::{Inertia, Symmetric};

/// Moves inboard what the joint of body `k` lets pass; to be called from the last body to the first.
pub fn pass_inboard(bodies: &mut Bodies<'_>, k: usize) {
    let body = bodies.bodies[k];
    let passes = invariant(body.motion, body.inertia);
    bodies.bodies[k].inertia = body.inertia - passes;
    let inboard = match body.parent {
        Some(parent) => &mut bodies.bodies[parent].inertia,
        None => &mut bodies.base,
    };
    *inboard = *inboard + passes.change_frame(body.placement);
}

/// The part of an inertia that is the same in every position of the joint, seen from its parent:
/// * turning about z moves no mass that lies on z: m, ∫z, ∫z²;
/// * sliding along z changes no second moment of a body without mass and first moments;
/// * a screw does both, so that only ∫z² of such a body remains.
fn invariant(motion: Motion, inertia: Inertia<Term<'_>>) -> Inertia<Term<'_>> {
    let mut part = Inertia::zero(inertia.mass.graph());
    let [_, _, zz, ..] = inertia.second.0;
    let zero = part.mass;
    let on_axis = Symmetric([zero, zero, zz, zero, zero, zero]);
    match motion {
        Motion::Revolute => {
            part.mass = inertia.mass;
            part.q.0[2] = inertia.q.z();
            part.second = on_axis;
        }
        Motion::Prismatic => part.second = inertia.second,
        Motion::Screw(_) => part.second = on_axis,
    }
    part
}
