//! Bodies with their frames, which may be moved.
//!
//! In: a chain. Out: its bodies, with z along the joint's axis if the joint has one coordinate; and a function that
//! replaces a frame by another one.

use crate::chain::base_parameters::BaseParameters;
use crate::chain::{BodyId, Chain, Frame, Position};
use crate::closure::ResidualKind;
use crate::expression::{Double, Expr, Graph, Term};
use crate::joint::{ActuatorTerms, Motion};
use crate::list::{Id, List};
use crate::matrix::{Inertia, Pose, Rotation, Vector};
use crate::space::{FrameId, ParameterId, SphereId, VelocityId};

/// The bodies of a chain with their frames.
#[derive(Clone, Debug)]
pub struct Bodies<'g> {
    /// Parents before children, as in the chain.
    pub bodies: List<BodyId, Body<'g>>,
    /// J in frame 0 of the parameters that regrouping moved to the base.
    pub base: Inertia<Term<'g>>,
    /// The columns of the base regressor, as columns of the regressor, if base parameters are requested.
    pub base_columns: Vec<ParameterId>,
    /// True if the regressor has columns of armature, damping and friction after those of links.
    pub identifies_actuators: bool,
    /// The requested frames, followed by A and B of each loop and by those at the centres of spheres: the joint whose body
    /// carries it, and M of the frame in that body's frame.
    pub frames: List<FrameId, (Option<BodyId>, Pose<Term<'g>>)>,
    /// The frame and the radius \[m\] of each collision sphere.
    pub spheres: List<SphereId, (FrameId, Term<'g>)>,
    /// The pairs of spheres that have distances.
    pub pairs: Vec<[SphereId; 2]>,
    /// The loops.
    pub loops: Vec<Closed<'g>>,
    /// The residuals of all loops in the order in which they are eliminated.
    pub elimination: Vec<usize>,
    /// The velocities with an actuator, if loops move the others.
    pub actuated: List<VelocityId, bool>,
    /// The links with an external wrench, in the same form.
    pub external: Vec<(Option<BodyId>, Pose<Term<'g>>)>,
    /// True if those wrenches are in frame 0.
    pub external_in_frame_0: bool,
    /// Acceleration of gravity in frame 0 [m/s²].
    pub gravity: Vector<Term<'g>>,
}

/// A joint that closes a loop.
#[derive(Clone, Debug)]
pub struct Closed<'g> {
    /// Frames A and B.
    pub frames: [FrameId; 2],
    /// Its residuals.
    pub rows: Vec<ResidualKind>,
    /// The length of a rod \[m\]; for a universal loop, the cosine of the angle between its axes.
    pub size: Term<'g>,
}

/// A body that moves about or along an axis of its frame.
#[derive(Clone, Copy, Debug)]
pub struct Body<'g> {
    /// The parent body; `None` for the fixed base.
    pub parent: Option<BodyId>,
    /// The motion of its joint.
    pub motion: Motion,
    /// The axis of its frame: z, unless the joint has several coordinates without axes of their own.
    pub axis: usize,
    /// The coordinates that determine its displacement.
    pub position: Position,
    /// Its index among the velocities.
    pub velocity: VelocityId,
    /// M of this frame in the parent's, at q + offset = 0.
    pub placement: Pose<Term<'g>>,
    /// Sine and cosine of the offset that is added to q.
    pub offset: Option<(Term<'g>, Term<'g>)>,
    /// J of the body in its frame.
    pub inertia: Inertia<Term<'g>>,
    /// M of its link's frame in this one; `None` for a body between two coordinates of a joint.
    pub link: Option<Pose<Term<'g>>>,
    /// Armature, damping and friction of its joint.
    pub actuator: ActuatorTerms<Term<'g>>,
}

impl Body<'_> {
    /// True if one coordinate moves it along its axis. Its frame can then be any other one that the motion leaves
    /// unchanged.
    #[must_use]
    pub const fn has_own_axis(&self) -> bool {
        matches!(self.position, Position::Along { .. })
    }

    /// The factor of its velocity; `None` if there is no factor.
    #[must_use]
    pub const fn factor(&self) -> Option<Expr> {
        match self.position {
            Position::Along { factor, .. } => Some(factor),
            Position::Manifold(..) | Position::Taken => None,
        }
    }

    /// True if its only motion is a translation.
    #[must_use]
    pub const fn translates_alone(&self) -> bool {
        self.has_own_axis() && self.motion.translates()
    }

    /// True if its only motion is a rotation, or a screw motion.
    #[must_use]
    pub const fn rotates_alone(&self) -> bool {
        self.has_own_axis() && !self.motion.translates()
    }
}

impl<'g> Bodies<'g> {
    /// The first child of body `k`.
    pub(super) fn first_child(&self, k: BodyId) -> Option<BodyId> {
        self.bodies.find(|child| child.parent == Some(k))
    }

    /// Replaces frame `k` by the one with pose `to` in it, which the joint's motion must leave unchanged.
    pub(super) fn move_frame(&mut self, k: BodyId, to: Pose<Term<'g>>) {
        let from = to.inverse();
        let body = &mut self.bodies[k];
        body.placement = body.placement * to;
        body.inertia = body.inertia.change_frame(from);
        body.link = body.link.map(|link| from * link);
        for child in &mut self.bodies {
            if child.parent == Some(k) {
                child.placement = from * child.placement;
            }
        }
        for (body, placement) in self.frames.iter_mut().chain(&mut self.external) {
            if *body == Some(k) {
                *placement = from * *placement;
            }
        }
    }
}

/// The bodies as described, each frame rotated so that z is its joint's axis.
pub(super) fn aligned<'g>(graph: &'g Graph, chain: &Chain) -> Bodies<'g> {
    let term = |expr| graph.term(expr);
    let rotations = chain.joints.map(|joint| match joint.position {
        Position::Along { .. } => Pose::rotation(Rotation::with_z(joint.axis.map(term))),
        Position::Manifold(..) | Position::Taken => Pose::identity(graph),
    });
    let seen_from = |parent: Option<BodyId>, pose: Pose<Term<'g>>| match parent {
        Some(parent) => rotations[parent].inverse() * pose,
        None => pose,
    };
    let bodies = (chain.joints.iter().zip(&rotations))
        .map(|(joint, &rotation)| Body {
            parent: joint.parent,
            motion: joint.motion,
            axis: match joint.position {
                Position::Along { .. } => 2,
                Position::Manifold(..) | Position::Taken => along(joint.axis.map(term)),
            },
            position: joint.position,
            velocity: joint.velocity,
            placement: seen_from(joint.parent, joint.placement.map(term) * rotation),
            offset: None,
            inertia: joint.inertia.map(term).change_frame(rotation.inverse()),
            link: (joint.link.as_ref()).map(|(_, link)| rotation.inverse() * link.map(term)),
            actuator: joint.actuator.map(term),
        })
        .collect();
    let of_loops = chain.loops.iter().flat_map(|closed| &closed.frames);
    let place = |frame: &Frame| (frame.body, seen_from(frame.body, frame.placement.map(term)));
    let loops = chain.loops.iter().enumerate().map(|(k, closed)| {
        let [a, b] = [0, 1].map(|end| chain.frames.next().plus(2 * k + end));
        Closed {
            frames: [a, b],
            rows: closed.rows.clone(),
            size: term(closed.size),
        }
    });
    let first_sphere = chain.frames.next().plus(2 * chain.loops.len());
    let spheres = chain.spheres.numbered();
    let spheres = spheres.map(|(k, sphere)| (first_sphere.plus(k.index()), term(sphere.radius)));
    let of_spheres = chain.spheres.iter().map(|sphere| &sphere.frame);
    let frames = chain.frames.iter().chain(of_loops).chain(of_spheres);
    Bodies {
        bodies,
        spheres: spheres.collect(),
        pairs: chain.pairs.clone(),
        loops: loops.collect(),
        elimination: chain.elimination.clone(),
        actuated: chain.actuated.clone(),
        base: Inertia::zero(graph),
        base_columns: (chain.base_parameters.iter())
            .flat_map(BaseParameters::columns)
            .collect(),
        identifies_actuators: chain.identifies_actuators,
        frames: frames.map(place).collect(),
        external: chain.external.iter().map(place).collect(),
        external_in_frame_0: chain.request.external_in_frame_0,
        gravity: chain.gravity.map(term),
    }
}

/// The axis of the frame with a direction.
fn along(direction: Vector<Term<'_>>) -> usize {
    let is = |&k: &usize| direction.0[k].value().is_some_and(Double::is_one);
    (0..3)
        .find(is)
        .expect("such joints move along the axes of their frame")
}
