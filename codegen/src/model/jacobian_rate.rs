//! The derivatives of the Jacobians' columns, L̇ = W L − L W with W of the body that each joint moves, in three frames.
//!
//! In: the path from the base to a frame, and q̇. Out: one derivative of a screw a body. A motion along L leaves L
//! unchanged, so that for a joint with one velocity W of its parent body gives the same as that of the moved body; the
//! screws of a joint with several are constant in the frame of the last body, and all move with it.

use super::algorithm::Carried;
use super::carry::{DisplacedJoint, Path};
use super::jacobian::columns;
use super::moving::velocities;
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Pose, Screw, Vector, Velocity};

/// Columns in frame 0, with the pole at its origin.
pub fn spatial<'g>(path: &Path<'g>, state: &State<'g>) -> List<BodyId, Screw<Term<'g>>> {
    let mut w = Velocity::zero(state.graph);
    let mut found = Vec::new();
    for together in path.outwards().chunk_by(|_, (next, _)| next.taken) {
        let screws = seen(together);
        let outer = w;
        w = w + own(&screws, state);
        let w = if screws.len() == 1 { outer } else { w };
        found.extend(screws.iter().map(|&(k, screw)| (k, w.rate_of(screw))));
    }
    columns(path, found.into_iter())
}

/// Columns in the axes of frame 0, with the pole at the origin of the frame at the end, which moves.
pub fn geometric<'g>(
    path: &Path<'g>,
    state: &State<'g>,
    carried: Carried,
) -> List<BodyId, Screw<Term<'g>>> {
    match carried {
        Carried::Inwards { .. } => geometric_in_links(path, state),
        Carried::Outwards => geometric_in_frame_0(path, state),
    }
}

/// The columns in the frames of the links, from the pole's position in each body and its velocity relative to it.
fn geometric_in_links<'g>(path: &Path<'g>, state: &State<'g>) -> List<BodyId, Screw<Term<'g>>> {
    let (mut tip, mut rate) = (path.end.translation, Vector::zero(state.graph));
    let mut poles = Vec::with_capacity(path.joints.len());
    for together in path.joints.chunk_by(|_, next| next.taken).rev() {
        poles.extend(together.iter().map(|_| (tip, rate)));
        let own = own(&local(together), state);
        let joint = &together[0];
        rate = joint.vector_inboard(rate + own.omega.cross(tip) + own.v);
        tip = joint.point_inboard(tip);
    }
    poles.reverse();
    let velocities = velocities(&path.joints, state);
    let placed = path.outwards().into_iter().zip(poles).enumerate();
    let rates = placed.map(|(k, ((joint, pose), (tip, rate)))| {
        // All bodies of a joint move as the last one.
        let taken = path.joints[k + 1..].iter().take_while(|next| next.taken);
        let w = velocities[k + taken.count()];
        let Screw { u, b } = joint.screw;
        let at_tip = b + u.cross(tip);
        let turned = Screw {
            u: pose.rotation * w.omega.cross(u),
            b: pose.rotation * (w.omega.cross(at_tip) + u.cross(rate)),
        };
        (joint.body, turned)
    });
    columns(path, rates)
}

/// The columns with all matrices in frame 0, about the end effector.
fn geometric_in_frame_0<'g>(path: &Path<'g>, state: &State<'g>) -> List<BodyId, Screw<Term<'g>>> {
    let mut omega = Vector::zero(state.graph);
    let mut outwards = Vec::new();
    for together in path.outwards_from_end().chunk_by(|_, (next, _)| next.taken) {
        let screws = seen(together);
        let outer = omega;
        omega = omega + own(&screws, state).omega;
        let omega = if screws.len() == 1 { outer } else { omega };
        outwards.push((screws, omega));
    }
    let mut v = Vector::zero(state.graph);
    let mut found = Vec::new();
    for (screws, omega) in outwards.into_iter().rev() {
        let beyond = v;
        v = v - own(&screws, state).v;
        let v = if screws.len() == 1 { v } else { beyond };
        let w = Velocity { omega, v };
        found.extend(screws.iter().map(|&(k, screw)| (k, w.rate_of(screw))));
    }
    columns(path, found.into_iter())
}

/// Columns in the frame at the end, with the pole at its origin: W of each body is relative to that frame, which the
/// joints beyond it move.
pub fn body<'g>(path: &Path<'g>, state: &State<'g>) -> List<BodyId, Screw<Term<'g>>> {
    let mut w = Velocity::zero(state.graph);
    let mut found = Vec::new();
    for together in path.inwards().chunk_by(|(joint, _), _| joint.taken) {
        let rates = together.iter().map(|(joint, pose)| {
            let rate = w.rate_of(joint.screw).change_frame(*pose);
            (joint.body, rate)
        });
        found.extend(rates);
        let joints: Vec<DisplacedJoint<'g>> =
            together.iter().rev().map(|&(joint, _)| joint).collect();
        w = joints[0].motion_inboard(w - own(&local(&joints), state));
    }
    columns(path, found.into_iter())
}

/// The screws of some bodies, each with its number, in the frame in which their poses are given.
fn seen<'g>(bodies: &[(DisplacedJoint<'g>, Pose<Term<'g>>)]) -> Vec<(BodyId, Screw<Term<'g>>)> {
    let bodies = bodies.iter();
    bodies
        .map(|(joint, pose)| (joint.body, joint.screw.change_frame(*pose)))
        .collect()
}

/// The same in the frames of the bodies.
fn local<'g>(bodies: &[DisplacedJoint<'g>]) -> Vec<(BodyId, Screw<Term<'g>>)> {
    let bodies = bodies.iter();
    bodies.map(|joint| (joint.body, joint.screw)).collect()
}

/// W of a joint alone.
fn own<'g>(screws: &[(BodyId, Screw<Term<'g>>)], state: &State<'g>) -> Velocity<Term<'g>> {
    let each = screws.iter();
    let each = each.map(|&(k, screw)| Velocity::of_screw(screw, state.qd(k)));
    each.reduce(|sum, w| sum + w).expect("a joint moves")
}
