//! All matrices in frame 0, as the paper has them (eqs. 8 to 28): what moves with a body is taken
//! there once, by M L M⁻¹ and M J Mᵗ, and from then on everything is a sum.
//!
//! In: the joints and bodies, or the way to a frame. Out: the same results as in the frames of the
//! links, for more work and with the digits lost that the distance from frame 0 takes.

use super::State;
use super::carry::{Joint, Path};
use super::jacobian::columns;
use crate::expression::Term;
use crate::matrix::{Acceleration, Action, Inertia, Pose, Screw, Vector, Velocity};

/// A body in frame 0.
struct Placed<'g> {
    parent: Option<usize>,
    /// L of its joint.
    screw: Screw<Term<'g>>,
    /// Its J.
    inertia: Inertia<Term<'g>>,
}

fn placed<'g>(joints: &[Joint<'g>], state: &State<'g>) -> Vec<Placed<'g>> {
    let mut poses: Vec<Pose<Term<'g>>> = Vec::with_capacity(joints.len());
    let mut bodies = Vec::with_capacity(joints.len());
    for joint in joints {
        let base = Pose::identity(state.graph);
        let pose = joint.pose(joint.parent.map_or(base, |parent| poses[parent]));
        let index = joint.index + 1;
        let screw = seen(joint, pose);
        let inertia = joint.inertia.change_frame(pose);
        inertia.label(|| format!("j_{index}_in_0_"));
        poses.push(pose);
        bodies.push(Placed {
            parent: joint.parent,
            screw,
            inertia,
        });
    }
    bodies
}

/// L of a joint in frame 0.
fn seen<'g>(joint: &Joint<'g>, pose: Pose<Term<'g>>) -> Screw<Term<'g>> {
    let screw = joint.screw.change_frame(pose);
    let index = joint.index + 1;
    screw.u.label(|| format!("l_{index}_in_0_u"));
    screw.b.label(|| format!("l_{index}_in_0_b"));
    screw
}

/// τ of a motion with the given q̈, one entry a joint.
pub fn inverse_dynamics<'g>(
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
    qdd: &[Term<'g>],
) -> Vec<Term<'g>> {
    let bodies = placed(joints, state);
    // Gravity is an acceleration of the base the other way.
    let base = Acceleration::linear(-gravity);
    let mut accelerations: Vec<Acceleration<Term<'g>>> = Vec::with_capacity(joints.len());
    let mut actions: Vec<Action<Term<'g>>> = Vec::with_capacity(joints.len());
    for (k, body) in bodies.iter().enumerate() {
        let outer = body.parent.map_or(base, |parent| accelerations[parent]);
        let h = beyond(outer, body.screw, state.qd(k), qdd[k]);
        let index = k + 1;
        h.omega.label(|| format!("w_0_{index}_in_0_"));
        h.omega_dot.label(|| format!("wd_0_{index}_in_0_"));
        h.a.label(|| format!("h_0_{index}_in_0_"));
        accelerations.push(h);
        actions.push(Action::of(h, body.inertia));
    }
    let mut tau = vec![state.zero(); joints.len()];
    for (k, body) in bodies.iter().enumerate().rev() {
        let action = actions[k];
        let index = k + 1;
        action.label(|| format!("phi_{index}_in_0_"));
        tau[k] = action.along(body.screw);
        if let Some(parent) = body.parent {
            actions[parent] = actions[parent] + action;
        }
    }
    tau
}

/// τ at rest, one entry a joint: the moment of the composite first moments about each axis.
pub fn gravity<'g>(
    joints: &[Joint<'g>],
    gravity: Vector<Term<'g>>,
    state: &State<'g>,
) -> Vec<Term<'g>> {
    let bodies = placed(joints, state);
    let composites = composites(&bodies);
    let weights = bodies.iter().zip(composites).map(|(body, composite)| {
        let weight = Action {
            c: composite.q.cross(-gravity),
            f: -gravity * composite.mass,
        };
        weight.along(body.screw)
    });
    weights.collect()
}

/// The mass matrix, row by row: Lᵢ ⊗ skew\[Lₖ J\] of the composite J outboard of joint k.
pub fn mass_matrix<'g>(joints: &[Joint<'g>], state: &State<'g>) -> Vec<Term<'g>> {
    let bodies = placed(joints, state);
    let count = bodies.len();
    let mut entries = vec![state.zero(); count * count];
    for (column, composite) in composites(&bodies).into_iter().enumerate() {
        let action = Action::of_screw(bodies[column].screw, composite);
        let mut at = Some(column);
        while let Some(row) = at {
            let entry = action.along(bodies[row].screw);
            entries[row * count + column] = entry;
            entries[column * count + row] = entry;
            at = bodies[row].parent;
        }
    }
    entries
}

/// J of each body with all that it carries.
fn composites<'g>(bodies: &[Placed<'g>]) -> Vec<Inertia<Term<'g>>> {
    let mut composites: Vec<_> = bodies.iter().map(|body| body.inertia).collect();
    for (k, body) in bodies.iter().enumerate().rev() {
        if let Some(parent) = body.parent {
            composites[parent] = composites[parent] + composites[k];
        }
    }
    composites
}

/// Columns of the Jacobian in the frame at the end, pole at its origin: L of frame 0, taken there.
pub fn body_jacobian<'g>(path: &Path<'g>) -> Vec<Term<'g>> {
    let steps = path.outwards();
    let end = steps.last().map_or(path.end, |&(_, pose)| pose * path.end);
    let back = end.inverse();
    let screws = steps.iter().map(|(joint, pose)| {
        let screw = seen(joint, *pose);
        (joint.index, screw.change_frame(back))
    });
    columns(path, screws)
}

/// W of the frame at the end of a path: ω, v₀.
pub fn velocity<'g>(path: &Path<'g>, state: &State<'g>) -> Vec<Term<'g>> {
    let mut w = Velocity::zero(state.graph);
    for (joint, pose) in path.outwards() {
        w = w + Velocity::of_screw(seen(&joint, pose), state.qd(joint.index));
    }
    [w.omega.0, w.v.0].concat()
}

/// H of the frame at the end of a path, row by row of (G, a₀).
pub fn acceleration<'g>(path: &Path<'g>, state: &State<'g>) -> Vec<Term<'g>> {
    let mut h = Acceleration::linear(Vector::zero(state.graph));
    for (joint, pose) in path.outwards() {
        let (rate, second) = (state.qd(joint.index), state.qdd(joint.index));
        h = beyond(h, seen(&joint, pose), rate, second);
    }
    h.entries().to_vec()
}

/// H of the body beyond a joint: Hᵢₖ = Hᵢⱼ + Hⱼₖ + 2 Wᵢⱼ Wⱼₖ (eq. 11) by its parts.
fn beyond<'g>(
    outer: Acceleration<Term<'g>>,
    screw: Screw<Term<'g>>,
    rate: Term<'g>,
    second: Term<'g>,
) -> Acceleration<Term<'g>> {
    let own = Velocity::of_screw(screw, rate);
    let two = rate.graph().constant(2.0);
    Acceleration {
        omega: outer.omega + own.omega,
        omega_dot: outer.omega_dot + screw.u * second + outer.omega.cross(own.omega),
        a: outer.a + screw.b * second + own.omega.cross(own.v) + outer.omega.cross(own.v) * two,
    }
}
