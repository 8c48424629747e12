//! W of bodies, outwards from the base, each where its joint's matrices are.

use super::carry::Joint;
use super::state::State;
use crate::expression::Term;
use crate::matrix::Velocity;

/// W of all bodies in the order of their joints; parents come before children.
pub fn velocities<'g>(joints: &[Joint<'g>], state: &State<'g>) -> Vec<Velocity<Term<'g>>> {
    let mut found: Vec<Velocity<Term<'g>>> = Vec::with_capacity(joints.len());
    for joint in joints {
        let outer = joints[..found.len()]
            .iter()
            .rposition(|outer| Some(outer.index) == joint.parent);
        let outer = outer.map_or(Velocity::zero(state.graph), |outer| found[outer]);
        let w =
            joint.motion_outboard(outer) + Velocity::of_screw(joint.screw, state.qd(joint.index));
        let (index, frame) = (joint.index + 1, joint.frame);
        w.omega.label(|| format!("w_0_{index}_in_{frame}_"));
        w.v.label(|| format!("w_0_{index}_in_{frame}_v"));
        found.push(w);
    }
    found
}
