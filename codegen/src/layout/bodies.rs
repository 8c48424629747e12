//! Bodies with their frames, which may be moved.
//!
//! In: a chain. Out: its bodies, each frame turned so that its joint's axis is z, and what replaces a
//! frame by another one. It never chooses one.

use super::frames::z_along;
use crate::chain::Chain;
use crate::expression::{Graph, Term};
use crate::joint::Motion;
use crate::matrix::{Inertia, Pose, Vector};

/// The bodies of a chain with their frames.
#[derive(Clone, Debug)]
pub struct Bodies<'g> {
    /// In the order of q, parents before children.
    pub bodies: Vec<Body<'g>>,
    /// J in frame 0 of what regrouping left to the base.
    pub base: Inertia<Term<'g>>,
    /// The frames asked for: the joint whose body carries it, and M from that body to it.
    pub frames: Vec<(Option<usize>, Pose<Term<'g>>)>,
    /// Acceleration of gravity in frame 0 [m/s²].
    pub gravity: Vector<Term<'g>>,
}

/// A body whose joint moves it about or along the z axis of its frame.
#[derive(Clone, Copy, Debug)]
pub struct Body<'g> {
    /// The body it hangs on; none for the fixed base.
    pub parent: Option<usize>,
    /// What its joint lets it do.
    pub motion: Motion,
    /// M from the parent's frame to this one at q + offset = 0.
    pub placement: Pose<Term<'g>>,
    /// Sine and cosine of what is added to q to give the angle about z.
    pub offset: Option<(Term<'g>, Term<'g>)>,
    /// J of the body in its frame.
    pub inertia: Inertia<Term<'g>>,
}

impl<'g> Bodies<'g> {
    /// The first body that hangs on body `k`.
    pub(super) fn first_child(&self, k: usize) -> Option<usize> {
        (k + 1..self.bodies.len()).find(|&child| self.bodies[child].parent == Some(k))
    }

    /// Replaces frame `k` by one seen from it at `to`, which the joint's motion must not move.
    pub(super) fn move_frame(&mut self, k: usize, to: Pose<Term<'g>>) {
        let from = to.inverse();
        let body = &mut self.bodies[k];
        body.placement = body.placement * to;
        body.inertia = body.inertia.change_frame(from);
        for child in &mut self.bodies[k + 1..] {
            if child.parent == Some(k) {
                child.placement = from * child.placement;
            }
        }
        for (body, placement) in &mut self.frames {
            if *body == Some(k) {
                *placement = from * *placement;
            }
        }
    }
}

/// The bodies as described, each frame turned so that its joint's axis is z.
pub(super) fn aligned<'g>(graph: &'g Graph, chain: &Chain) -> Bodies<'g> {
    let term = |expr| graph.term(expr);
    let turns: Vec<Pose<Term<'g>>> = (chain.joints.iter())
        .map(|joint| Pose::rotation(z_along(joint.axis.map(term))))
        .collect();
    let seen_from = |parent: Option<usize>, pose: Pose<Term<'g>>| match parent {
        Some(parent) => turns[parent].inverse() * pose,
        None => pose,
    };
    let bodies = (chain.joints.iter().zip(&turns))
        .map(|(joint, &turn)| Body {
            parent: joint.parent,
            motion: joint.motion,
            placement: seen_from(joint.parent, joint.placement.map(term) * turn),
            offset: None,
            inertia: joint.inertia.map(term).change_frame(turn.inverse()),
        })
        .collect();
    let frames = (chain.frames.iter())
        .map(|frame| (frame.body, seen_from(frame.body, frame.placement.map(term))))
        .collect();
    Bodies {
        bodies,
        base: Inertia::zero(graph),
        frames,
        gravity: chain.gravity.map(term),
    }
}
