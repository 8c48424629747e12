//! Bodies with their frames, which may be moved.
//!
//! In: a chain. Out: its bodies, each frame turned so that its joint's axis is z where the joint has one
//! coordinate, and what replaces a frame by another one. It never chooses one.

use crate::chain::base_parameters::BaseParameters;
use crate::chain::{BodyId, Chain, Frame, Position};
use crate::closure::Row;
use crate::expression::{Double, Expr, Graph, Term};
use crate::joint::{Drive, Motion};
use crate::list::{Id, List};
use crate::matrix::{Inertia, Pose, Rotation, Vector};
use crate::space::{FrameId, ParameterId, VelocityId};

/// The bodies of a chain with their frames.
#[derive(Clone, Debug)]
pub struct Bodies<'g> {
    /// Parents before children, as in the chain.
    pub bodies: List<BodyId, Body<'g>>,
    /// J in frame 0 of what regrouping left to the base.
    pub base: Inertia<Term<'g>>,
    /// The columns of the regressor that the base regressor has, where base parameters are asked for.
    pub base_columns: Vec<ParameterId>,
    /// Whether the regressor has columns of drives behind those of links.
    pub identifies_drives: bool,
    /// The frames asked for, and behind them A and B of each loop: the joint whose body carries it, and M
    /// from that body to it.
    pub frames: List<FrameId, (Option<BodyId>, Pose<Term<'g>>)>,
    /// The loops.
    pub loops: Vec<Closed<'g>>,
    /// Which velocities are driven, where loops move the others.
    pub actuated: List<VelocityId, bool>,
    /// The links on which something acts from outside, in the same way.
    pub external: Vec<(Option<BodyId>, Pose<Term<'g>>)>,
    /// Whether those actions are in frame 0.
    pub external_in_frame_0: bool,
    /// Acceleration of gravity in frame 0 [m/s²].
    pub gravity: Vector<Term<'g>>,
}

/// A joint that closes a loop.
#[derive(Clone, Debug)]
pub struct Closed<'g> {
    /// Frames A and B.
    pub frames: [FrameId; 2],
    /// What it closes.
    pub rows: Vec<Row>,
    /// The length of a rod \[m\]; of a joint with two axes, the cosine of their angle.
    pub size: Term<'g>,
}

/// A body, moved about or along an axis of its frame.
#[derive(Clone, Copy, Debug)]
pub struct Body<'g> {
    /// The body it hangs on; none for the fixed base.
    pub parent: Option<BodyId>,
    /// What its joint lets it do.
    pub motion: Motion,
    /// About or along which axis of its frame: z, but where the joint has taken the frame anywhere.
    pub axis: usize,
    /// What its displacement is a function of.
    pub position: Position,
    /// Its place among the velocities.
    pub velocity: VelocityId,
    /// M from the parent's frame to this one at q + offset = 0.
    pub placement: Pose<Term<'g>>,
    /// Sine and cosine of what is added to q to give the angle about z.
    pub offset: Option<(Term<'g>, Term<'g>)>,
    /// J of the body in its frame.
    pub inertia: Inertia<Term<'g>>,
    /// M from this frame to that of the link that the body is; none for one between two coordinates of a joint.
    pub link: Option<Pose<Term<'g>>>,
    /// What is modelled of its joint's drive.
    pub drive: Drive<Term<'g>>,
}

impl Body<'_> {
    /// Whether one coordinate moves it along its axis: another frame than its own will do then, anywhere that
    /// the motion leaves as it is.
    #[must_use]
    pub const fn has_own_axis(&self) -> bool {
        matches!(self.position, Position::Along { .. })
    }

    /// What its rate is the product of with its velocity; none where it is that velocity.
    #[must_use]
    pub const fn factor(&self) -> Option<Expr> {
        match self.position {
            Position::Along { factor, .. } => Some(factor),
            Position::Posture(..) | Position::Taken => None,
        }
    }

    /// Whether that lets it slide, and never turns it.
    #[must_use]
    pub const fn slides_alone(&self) -> bool {
        self.has_own_axis() && self.motion.slides()
    }

    /// Whether that turns it.
    #[must_use]
    pub const fn turns_alone(&self) -> bool {
        self.has_own_axis() && !self.motion.slides()
    }
}

impl<'g> Bodies<'g> {
    /// The first body that hangs on body `k`.
    pub(super) fn first_child(&self, k: BodyId) -> Option<BodyId> {
        self.bodies.find(|child| child.parent == Some(k))
    }

    /// Replaces frame `k` by one seen from it at `to`, which the joint's motion must not move.
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

/// The bodies as described, each frame turned so that its joint's axis is z.
pub(super) fn aligned<'g>(graph: &'g Graph, chain: &Chain) -> Bodies<'g> {
    let term = |expr| graph.term(expr);
    let turns = chain.joints.map(|joint| match joint.position {
        Position::Along { .. } => Pose::rotation(Rotation::with_z(joint.axis.map(term))),
        Position::Posture(..) | Position::Taken => Pose::identity(graph),
    });
    let seen_from = |parent: Option<BodyId>, pose: Pose<Term<'g>>| match parent {
        Some(parent) => turns[parent].inverse() * pose,
        None => pose,
    };
    let bodies = (chain.joints.iter().zip(&turns))
        .map(|(joint, &turn)| Body {
            parent: joint.parent,
            motion: joint.motion,
            axis: match joint.position {
                Position::Along { .. } => 2,
                Position::Posture(..) | Position::Taken => along(joint.axis.map(term)),
            },
            position: joint.position,
            velocity: joint.velocity,
            placement: seen_from(joint.parent, joint.placement.map(term) * turn),
            offset: None,
            inertia: joint.inertia.map(term).change_frame(turn.inverse()),
            link: (joint.link.as_ref()).map(|(_, link)| turn.inverse() * link.map(term)),
            drive: joint.drive.map(term),
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
    Bodies {
        bodies,
        loops: loops.collect(),
        actuated: chain.actuated.clone(),
        base: Inertia::zero(graph),
        base_columns: (chain.base_parameters.iter())
            .flat_map(BaseParameters::columns)
            .collect(),
        identifies_drives: chain.identifies_drives,
        frames: chain.frames.iter().chain(of_loops).map(place).collect(),
        external: chain.external.iter().map(place).collect(),
        external_in_frame_0: chain.request.external_in_frame_0,
        gravity: chain.gravity.map(term),
    }
}

/// Which axis of the frame a direction is.
fn along(direction: Vector<Term<'_>>) -> usize {
    let is = |&k: &usize| direction.0[k].value().is_some_and(Double::is_one);
    (0..3)
        .find(is)
        .expect("such joints move along the axes of their frame")
}
