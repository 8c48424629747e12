//! Joint forces and torques that hold a robot at rest: the moment of the composite first moments
//! about each axis. Only masses and first moments enter, and no force has to be carried.

use super::carry::Joint;
use super::state::State;
use crate::expression::Term;
use crate::matrix::Vector;

/// τ at rest, one entry a joint.
pub fn gravity<'g>(
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
) -> Vec<Term<'g>> {
    let count = joints.len();
    // Acceleration of the base that has the effect of gravity, in each frame.
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
    tau
}
