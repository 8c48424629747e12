//! A joint at work: how matrices get from one side of it to the other.
//!
//! In: the bodies and the state. Out: the displacements of their joints, each a turn and a slide,
//! of all of them or of those on the way from the base to a frame. A frame that leaves its turn to
//! what it carries ([`turn`](super::turn)) is not fixed to its body; all matrices are of one
//! instant, so no formula minds. Neither does any where all matrices are in frame 0: each L and J is
//! taken there, and from one body to the next nothing is left to be carried.

use std::iter::successors;

use super::state::State;
use super::turn::{self, Turn};
use super::way::{Congruence, Way};
use crate::chain::{BodyId, Position};
use crate::expression::{Block, Numeral, Of, Term};
use crate::formulation::Frame;
use crate::joint::{Drive, Motion};
use crate::layout::{Bodies, Body};
use crate::list::{Id, List};
use crate::matrix::{Inertia, Pose, Rotation, Screw, Vector, Velocity};
use crate::space::FrameId;

/// A joint and its body: in the frame of the body the displacement is a turn about z and a slide along it,
/// or a posture; in frame 0 there is none, and the placement is the identity.
#[derive(Clone, Copy)]
pub struct Joint<'g> {
    /// The body.
    pub body: BodyId,
    /// The joint that carries the body it hangs on; none for the fixed base.
    pub parent: Option<BodyId>,
    /// The motion it allows.
    pub motion: Motion,
    /// Where its matrices are.
    pub frame: Frame,
    /// Whether what is placed in frame 0 is seen from the root, in the axes of frame 0.
    pub from_root: bool,
    /// M from the parent's frame to where the displacement starts.
    pub placement: Pose<Term<'g>>,
    /// Sine and cosine of the turn.
    pub angle: (Term<'g>, Term<'g>),
    /// The slide \[m\].
    pub slide: Term<'g>,
    /// What stands in the place of both where the body is moved in several ways at once.
    pub posture: Option<Pose<Term<'g>>>,
    /// Whether it is moved so by the body before it, whose frame is its own.
    pub taken: bool,
    /// About or along which axis of its frame it moves; z where both are its own.
    pub axis: usize,
    /// L of the joint.
    pub screw: Screw<Term<'g>>,
    /// J of the body.
    pub inertia: Inertia<Term<'g>>,
    /// What is modelled of its drive.
    pub drive: Drive<Term<'g>>,
    /// How inertias turn with it.
    pub congruence: Congruence,
}

/// The joints of all bodies.
pub type Joints<'g> = List<BodyId, Joint<'g>>;

impl<'g> Joint<'g> {
    /// The joint of body `k`, where `left` is what each body's frame leaves of its turn.
    fn new(
        bodies: &Bodies<'g>,
        k: BodyId,
        state: &State<'g>,
        left: &List<BodyId, Option<Turn<'g>>>,
        congruence: Congruence,
    ) -> Self {
        let body: &Body<'g> = &bodies.bodies[k];
        let graph = state.graph;
        let (zero, one) = (state.zero(), graph.constant(1.0));
        let outer = body.parent.and_then(|parent| left[parent]);
        let angle = match left[k] {
            Some(_) => (zero, one),
            None => turn::of_body(body, k, state, outer).sine_and_cosine(graph),
        };
        let slide = body.motion.slide(|| state.q(k)).unwrap_or(zero);
        let posture = match body.position {
            Position::Posture(posture, first) => {
                Some(posture.displacement(|entry| state.coordinate(first.plus(entry))))
            }
            Position::Along { .. } | Position::Taken => None,
        };
        let mut axis = [zero; 3];
        axis[body.axis] = one;
        let mut placement = body.placement;
        if let Some(outer) = outer {
            let turned = Rotation::about_z(outer.sine_and_cosine(graph));
            placement.translation = turned * placement.translation;
        }
        Self {
            body: k,
            parent: body.parent,
            motion: body.motion,
            frame: Frame::Link,
            from_root: false,
            placement,
            angle,
            slide,
            posture,
            taken: matches!(body.position, Position::Taken),
            axis: body.axis,
            screw: body.motion.screw(Vector(axis)),
            inertia: match left[k] {
                Some(turn) => body.inertia.rotate_about_z(turn.sine_and_cosine(graph)),
                None => body.inertia,
            },
            drive: body.drive,
            congruence,
        }
    }

    /// The joint with all its matrices in frame 0, where its body is at a pose: M L M⁻¹ and M J Mᵗ, as
    /// the paper has them (eqs. 8 and 17).
    fn in_frame_0(self, pose: Pose<Term<'g>>) -> Self {
        let graph = self.slide.graph();
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        let index = self.body.into();
        let screw = self.screw.change_frame(pose);
        let of = Of::Body(index);
        screw
            .u
            .label(Block::Direction.of(of).seen_in(Numeral::BASE));
        screw.b.label(Block::Moment.of(of).seen_in(Numeral::BASE));
        let inertia = self.inertia.change_frame(pose);
        inertia.label(index, Numeral::BASE);
        Self {
            frame: Frame::Base,
            placement: Pose::identity(graph),
            angle: (zero, one),
            slide: zero,
            posture: None,
            screw,
            inertia,
            ..self
        }
    }

    /// M₀ of the body, where `outer` is that of the body it hangs on.
    fn pose(&self, outer: Pose<Term<'g>>) -> Pose<Term<'g>> {
        let pose = outer * self.placement * self.displacement();
        let of = Of::FromBase(self.body.into());
        if !self.from_root {
            pose.translation.label(Block::Origin.of(of));
        }
        for k in 0..3 {
            pose.rotation.column(k).label(Block::Axis(k).of(of));
        }
        pose
    }

    /// Leaves the origin of a body at the root where that of frame 0 is: it turns there.
    fn stay(&mut self) {
        let zero = Vector::zero(self.slide.graph());
        self.placement.translation = zero;
        self.slide = zero.x();
        if let Some(posture) = &mut self.posture {
            posture.translation = zero;
        }
    }

    /// Whether its motion carries the screw of a joint `at` inboard of it: its own, and those of the joint with
    /// several velocities of which it is one.
    pub fn carries_screw(&self, at: BodyId, joints: &List<BodyId, Self>) -> bool {
        let mut own = successors(Some(self), |joint| {
            joint.parent.filter(|_| joint.taken).map(|k| &joints[k])
        });
        own.any(|joint| joint.body == at)
    }

    /// The numbers of its body and of the frame in which its matrices are, as names have them; frame 0 is that of the
    /// base.
    pub fn numbers(&self) -> (Numeral, Numeral) {
        let body = self.body.into();
        match self.frame {
            Frame::Link => (body, body),
            Frame::Base => (body, Numeral::BASE),
        }
    }

    /// The number of the frame in which the matrices of the body are that it hangs on.
    pub fn outer_frame_number(&self) -> Numeral {
        match (self.frame, self.parent) {
            (Frame::Link, Some(parent)) => parent.into(),
            (Frame::Link, None) | (Frame::Base, _) => Numeral::BASE,
        }
    }

    /// The turn as a matrix.
    pub fn turn(&self) -> Rotation<Term<'g>> {
        self.posture
            .map_or_else(|| Rotation::about_z(self.angle), |posture| posture.rotation)
    }

    /// The slide as a vector.
    pub fn offset(&self) -> Vector<Term<'g>> {
        let zero = self.slide.graph().constant(0.0);
        let slid = || Vector([zero, zero, self.slide]);
        self.posture
            .map_or_else(slid, |posture| posture.translation)
    }

    /// A vector of the body's axes in its parent's.
    pub fn vector_inboard(&self, vector: Vector<Term<'g>>) -> Vector<Term<'g>> {
        self.placement.rotation * (self.turn() * vector)
    }

    /// A point of the body's frame in its parent's.
    pub fn point_inboard(&self, point: Vector<Term<'g>>) -> Vector<Term<'g>> {
        self.placement.point(self.turn() * point + self.offset())
    }

    /// A vector of the parent's axes in the body's.
    pub fn vector_outboard(&self, vector: Vector<Term<'g>>) -> Vector<Term<'g>> {
        self.turn().transposed() * (self.placement.rotation.transposed() * vector)
    }

    /// A motion of the body it hangs on, in the body's frame.
    pub fn motion_outboard(&self, w: Velocity<Term<'g>>) -> Velocity<Term<'g>> {
        w.move_pole(self.placement.translation)
            .rotate(self.placement.rotation.transposed())
            .move_pole(self.offset())
            .rotate(self.turn().transposed())
    }

    /// First moments of a mass in the body's frame, in its parent's: R q + m p.
    pub fn first_moment_inboard(&self, q: Vector<Term<'g>>, mass: Term<'g>) -> Vector<Term<'g>> {
        let slid = self.turn() * q + self.offset() * mass;
        self.placement.rotation * slid + self.placement.translation * mass
    }

    /// J of the body in its parent's frame.
    pub fn inertia_inboard(&self, inertia: Inertia<Term<'g>>) -> Inertia<Term<'g>> {
        let moved = match self.posture {
            Some(posture) => inertia.change_frame(posture),
            None => self.turned(inertia).translate(self.offset()),
        };
        moved.change_frame(self.placement)
    }

    /// J of the body where its joint has not turned, but slid.
    pub fn turned(&self, inertia: Inertia<Term<'g>>) -> Inertia<Term<'g>> {
        match self.congruence {
            Congruence::Sparing => inertia.rotate_about_z(self.angle),
            Congruence::Full => inertia.rotate_in_full_about_z(self.angle),
        }
    }

    /// The displacement as a pose, from where it starts.
    pub fn displacement(&self) -> Pose<Term<'g>> {
        Pose {
            rotation: self.turn(),
            translation: self.offset(),
        }
    }
}

/// Joints, each with M₀ of its body; parents come before children.
pub(super) fn placed<'g>(joints: &[Joint<'g>]) -> Vec<(Joint<'g>, Pose<Term<'g>>)> {
    let mut found: Vec<(Joint<'g>, Pose<Term<'g>>)> = Vec::with_capacity(joints.len());
    for &joint in joints {
        let outer = (found.iter().rev()).find(|(outer, _)| Some(outer.body) == joint.parent);
        let base = || Pose::identity(joint.slide.graph());
        let pose = joint.pose(outer.map_or_else(base, |&(_, pose)| pose));
        found.push((joint, pose));
    }
    found
}

/// Joints with all their matrices in frame 0, of all bodies or of some.
pub fn in_frame_0<'g, J: FromIterator<Joint<'g>>>(joints: &[Joint<'g>]) -> J {
    let placed = placed(joints).into_iter();
    placed.map(|(joint, pose)| joint.in_frame_0(pose)).collect()
}

/// What the frame of each body leaves of its turn, where all joints are at work.
pub(super) fn left<'g>(
    bodies: &Bodies<'g>,
    state: &State<'g>,
    way: Way,
) -> List<BodyId, Option<Turn<'g>>> {
    turn::left_to_carried(bodies, state, way.angles, |k| {
        let mut carried = bodies
            .bodies
            .iter()
            .filter(|body| body.parent == Some(k))
            .peekable();
        carried.peek().is_some() && carried.all(turn::is_parallel)
    })
}

/// All joints, in the order of the bodies.
pub fn joints<'g>(bodies: &Bodies<'g>, state: &State<'g>, way: Way) -> Joints<'g> {
    let left = left(bodies, state, way);
    let all = bodies.bodies.ids();
    all.map(|k| Joint::new(bodies, k, state, &left, way.congruence))
        .collect()
}

/// The same joints and base, with the origin of frame 0 moved: to the body at the root where that is one and carries
/// all mass, or else to where the first root is placed.
pub fn from_root<'g>(
    mut joints: Joints<'g>,
    base: Inertia<Term<'g>>,
) -> (Joints<'g>, Inertia<Term<'g>>) {
    for joint in &mut joints {
        joint.from_root = true;
    }
    let mut roots: Vec<&mut Joint<'g>> = joints
        .iter_mut()
        .filter(|joint| joint.parent.is_none())
        .collect();
    match roots.as_mut_slice() {
        [root] if base.mass.is_zero() => {
            root.stay();
            (joints, base)
        }
        [first, ..] => {
            let origin = first.placement.translation;
            for root in roots {
                root.placement.translation = root.placement.translation - origin;
            }
            (joints, base.translate(-origin))
        }
        [] => (joints, base),
    }
}

/// The way from the base to a frame.
pub struct Path<'g> {
    /// Where the matrices of its joints are.
    pub frame: Frame,
    /// The joints that move the frame, from the base outwards.
    pub joints: Vec<Joint<'g>>,
    /// How many joints the robot has.
    pub count: usize,
    /// M from the last body to the frame, or M₀ of the frame where all matrices are in frame 0.
    pub end: Pose<Term<'g>>,
}

impl<'g> Path<'g> {
    /// The joints from the base outwards, each with M₀ of its body.
    pub fn outwards(&self) -> Vec<(Joint<'g>, Pose<Term<'g>>)> {
        placed(&self.joints)
    }

    /// The joints from the base outwards, each with M₀ of its body but seen from the origin of the frame at the end.
    ///
    /// What lies between them is summed, and not two ways from the base subtracted: that would lose what is short
    /// beside these.
    pub fn outwards_from_end(&self) -> Vec<(Joint<'g>, Pose<Term<'g>>)> {
        let mut placed = self.outwards();
        let graph = self.end.translation.x().graph();
        let mut between = match placed.last() {
            Some((_, last)) => last.rotation * self.end.translation,
            None => self.end.translation,
        };
        for k in (0..placed.len()).rev() {
            let outer = match k {
                0 => Rotation::identity(graph),
                _ => placed[k - 1].1.rotation,
            };
            let (joint, pose) = &mut placed[k];
            pose.translation = -between;
            let step = (joint.placement * joint.displacement()).translation;
            between = between + outer * step;
        }
        placed
    }

    /// The joints from the frame inwards, each with M of its body seen from the frame.
    pub fn inwards(&self) -> Vec<(Joint<'g>, Pose<Term<'g>>)> {
        let mut pose = self.end.inverse();
        let joints = self.joints.iter().rev().map(|joint| {
            let seen = (*joint, pose);
            pose = pose * joint.displacement().inverse() * joint.placement.inverse();
            seen
        });
        joints.collect()
    }

    /// M₀ of the frame.
    pub fn pose(&self) -> Pose<Term<'g>> {
        (self.outwards().last()).map_or(self.end, |&(_, pose)| pose * self.end)
    }

    /// The way with all its matrices in frame 0.
    pub fn in_frame_0(self) -> Self {
        Self {
            frame: Frame::Base,
            joints: in_frame_0(&self.joints),
            end: self.pose(),
            ..self
        }
    }
}

/// The way to a frame.
pub fn path<'g>(bodies: &Bodies<'g>, frame: FrameId, state: &State<'g>, way: Way) -> Path<'g> {
    path_beyond(bodies, None, frame, state, way)
}

/// The way to a frame from a body that carries it, or from the base: its placement at the
/// beginning is as seen from there.
pub fn path_beyond<'g>(
    bodies: &Bodies<'g>,
    from: Option<BodyId>,
    frame: FrameId,
    state: &State<'g>,
    way: Way,
) -> Path<'g> {
    let (last, end) = bodies.frames[frame];
    let inwards = || {
        let all = successors(last, |&k| bodies.bodies[k].parent);
        all.take_while(|&k| Some(k) != from)
    };
    let left = turn::left_to_carried(bodies, state, way.angles, |k| {
        let next = inwards().find(|&next| bodies.bodies[next].parent == Some(k));
        Some(k) != from && next.is_some_and(|next| turn::is_parallel(&bodies.bodies[next]))
    });
    let joints = inwards().map(|k| Joint::new(bodies, k, state, &left, way.congruence));
    let mut joints: Vec<Joint<'g>> = joints.collect();
    joints.reverse();
    Path {
        frame: Frame::Link,
        joints,
        count: bodies.bodies.len(),
        end,
    }
}
