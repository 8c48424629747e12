//! Joint forces and torques that hold a robot at rest: the moment of the composite first moments
//! about each axis. Only masses and first moments enter, and no force has to be carried.

use super::carry::Joint;
use super::state::State;
use crate::expression::Term;
use crate::matrix::{Screw, Vector};

/// τ at rest, one entry a joint.
pub fn gravity<'g>(
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
) -> Vec<Term<'g>> {
    rest(joints, gravity, state).tau
}

/// ∂τ/∂q at rest, row by row. Where one joint carries the other the entry is (a × u)·f, with f the force
/// that accelerates, along the outer joint's screw, all that it carries, and a × u what a turn about the
/// inner joint's axis makes of the acceleration that has the effect of gravity. It is symmetric, but for
/// velocities of one joint, each of which carries the screws of all.
pub fn derivative<'g>(
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
) -> Vec<Term<'g>> {
    let count = joints.len();
    let rest = rest(joints, gravity, state);
    let mut entries = vec![state.zero(); count * count];
    for k in 0..count {
        let mut force = rest.force(joints, k);
        let mut at = k;
        loop {
            let entry = rest.falling(joints, at).dot(force);
            entries[k * count + at] = entry;
            entries[at * count + k] = if joints[k].carries_screw(at, joints) {
                rest.falling(joints, k).dot(rest.force(joints, at))
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
    /// The acceleration of the base that has the effect of gravity.
    accelerations: Vec<Vector<Term<'g>>>,
    /// The mass of all that each joint carries.
    masses: Vec<Term<'g>>,
    /// Its first moments.
    moments: Vec<Vector<Term<'g>>>,
    /// τ of each joint.
    tau: Vec<Term<'g>>,
}

impl<'g> Rest<'g> {
    /// The force that accelerates all that a joint carries along its screw.
    fn force(&self, joints: &[Joint<'g>], k: usize) -> Vector<Term<'g>> {
        let Screw { u, b } = joints[k].screw;
        u.cross(self.moments[k]) + b * self.masses[k]
    }

    /// What a turn about the axis of a joint makes of the acceleration that has the effect of gravity.
    fn falling(&self, joints: &[Joint<'g>], k: usize) -> Vector<Term<'g>> {
        self.accelerations[k].cross(joints[k].screw.u)
    }
}

fn rest<'g>(joints: &[Joint<'g>], gravity: Vector<Term<'g>>, state: &State<'g>) -> Rest<'g> {
    let count = joints.len();
    let mut accelerations = Vec::with_capacity(count);
    for joint in joints {
        let outer = joint
            .parent
            .map_or(-gravity, |parent| accelerations[parent]);
        let a = joint.vector_outboard(outer);
        let (index, frame) = (joint.index + 1, joint.frame);
        a.label(|| format!("h_0_{index}_in_{frame}_"));
        accelerations.push(a);
    }
    let mut masses: Vec<_> = joints.iter().map(|joint| joint.inertia.mass).collect();
    let mut moments: Vec<_> = joints.iter().map(|joint| joint.inertia.q).collect();
    let mut tau = vec![state.zero(); count];
    for k in (0..count).rev() {
        let (joint, a) = (&joints[k], accelerations[k]);
        let (index, frame) = (k + 1, joint.frame);
        moments[k].label(|| format!("j_{index}_in_{frame}_"));
        let (screw, mass) = (joint.screw, masses[k]);
        let couple = screw.u.dot(moments[k].cross(a));
        // A mass folds into an acceleration that is known; beside one that is not, one product is enough.
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
