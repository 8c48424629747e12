//! Gravity torques, which hold a robot at rest: the moments of the composite first moments about each axis. Only masses
//! and first moments are needed, and no force is passed from body to body.

use super::carry::Joints;
use super::state::State;
use crate::chain::BodyId;
use crate::expression::{Block, LabelledBodies, Term};
use crate::list::{List, Square};
use crate::matrix::{Screw, Vector};

/// τ at rest, one entry a joint.
pub fn gravity<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
) -> List<BodyId, Term<'g>> {
    rest(joints, gravity, state).tau
}

/// ∂τ/∂q at rest, by rows. If one joint carries the other, the entry is (a × u)·f: f is the force that accelerates all
/// bodies outboard of the outer joint along its screw, and a × u the derivative of −gravity by a rotation about the
/// inner joint's axis. The matrix is symmetric, except for velocities of one joint, each of which moves the screws of
/// all.
pub fn derivative<'g>(
    joints: &Joints<'g>,
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
) -> Square<BodyId, Term<'g>> {
    let rest = rest(joints, gravity, state);
    let mut entries = Square::filled(state.zero(), joints.len());
    for k in joints.ids() {
        let mut force = rest.force(joints, k);
        let mut at = k;
        loop {
            let entry = rest.gravity_change(joints, at).dot(force);
            entries[(k, at)] = entry;
            entries[(at, k)] = if joints[k].carries_screw(at, joints) {
                rest.gravity_change(joints, k).dot(rest.force(joints, at))
            } else {
                entry
            };
            let Some(parent) = joints[at].parent else {
                break;
            };
            force = joints[at].vector_inboard(force);
            at = parent;
        }
    }
    entries
}

/// A robot at rest, each vector in the frame of its joint's matrices.
struct Rest<'g> {
    /// The acceleration of the base that replaces gravity.
    accelerations: List<BodyId, Vector<Term<'g>>>,
    /// The mass of all bodies that each joint carries.
    masses: List<BodyId, Term<'g>>,
    /// Its first moments.
    moments: List<BodyId, Vector<Term<'g>>>,
    /// τ of each joint.
    tau: List<BodyId, Term<'g>>,
}

impl<'g> Rest<'g> {
    /// The force that accelerates all bodies that a joint carries along its screw.
    fn force(&self, joints: &Joints<'g>, k: BodyId) -> Vector<Term<'g>> {
        let Screw { u, b } = joints[k].screw;
        u.cross(self.moments[k]) + b * self.masses[k]
    }

    /// The derivative, by a rotation about the axis of a joint, of the acceleration that replaces gravity.
    fn gravity_change(&self, joints: &Joints<'g>, k: BodyId) -> Vector<Term<'g>> {
        self.accelerations[k].cross(joints[k].screw.u)
    }
}

fn rest<'g>(joints: &Joints<'g>, gravity: Vector<Term<'g>>, state: &State<'g>) -> Rest<'g> {
    let mut accelerations = List::new();
    for joint in joints {
        let outer = joint
            .parent
            .map_or(-gravity, |parent| accelerations[parent]);
        let a = joint.vector_outboard(outer);
        let (index, frame) = joint.numbers();
        a.label(
            Block::LinearAcceleration
                .of(LabelledBodies::FromBase(index))
                .seen_in(frame),
        );
        accelerations.push(a);
    }
    let mut masses = joints.map(|joint| joint.inertia.mass);
    let mut moments = joints.map(|joint| joint.inertia.q);
    let mut tau = List::filled(state.zero(), joints.len());
    for (k, joint) in joints.numbered().rev() {
        let a = accelerations[k];
        let (index, frame) = joint.numbers();
        moments[k].label(
            Block::Inertia
                .of(LabelledBodies::Body(index))
                .seen_in(frame),
        );
        let (screw, mass) = (joint.screw, masses[k]);
        let couple = screw.u.dot(moments[k].cross(a));
        // A mass folds into a constant acceleration; beside a variable one, one product is enough.
        let known = a.0.iter().all(|entry| entry.value().is_some());
        let force = if known {
            screw.b.dot(a * mass)
        } else {
            screw.b.dot(a) * mass
        };
        tau[k] = couple + force;
        if let Some(parent) = joint.parent {
            let carried = joint.first_moment_inboard(moments[k], masses[k]);
            moments[parent] = moments[parent] + carried;
            masses[parent] = masses[parent] + masses[k];
        }
    }
    Rest {
        accelerations,
        masses,
        moments,
        tau,
    }
}
