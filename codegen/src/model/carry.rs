//! Joints with their displacements: changes of frame across a joint.
//!
//! In: the bodies and the state. Out: the displacements of their joints, each a rotation and a translation, for all of
//! them or for those on the path from the base to a frame. A frame that leaves its rotation to its child bodies
//! ([`axis_rotation`](super::axis_rotation)) is not fixed to its body; all matrices belong to one instant, so that every
//! formula still holds. The same is true with all matrices in frame 0: each L and J is taken there, and nothing changes
//! from one body to the next.

use std::iter::successors;

use super::algorithm::{Algorithm, Congruence};
use super::axis_rotation::{self, AxisRotation};
use super::state::State;
use crate::chain::{BodyId, Position};
use crate::expression::{Block, LabelledBodies, Numeral, Term};
use crate::formulation::Frame;
use crate::joint::{ActuatorTerms, Motion};
use crate::layout::{Bodies, Body};
use crate::list::{Id, List};
use crate::matrix::{Action, Inertia, Pose, Rotation, Screw, Vector, Velocity};
use crate::space::FrameId;

/// A joint and its body. In the frame of the body the displacement is a rotation about z and a translation along it, or
/// that of a ball, planar or floating joint; in frame 0 it is the identity, and so is the placement.
#[derive(Clone, Copy)]
pub struct DisplacedJoint<'g> {
    /// The body.
    pub body: BodyId,
    /// The joint that carries the parent body; `None` for the fixed base.
    pub parent: Option<BodyId>,
    /// Its type of motion.
    pub motion: Motion,
    /// The frame of its matrices.
    pub frame: Frame,
    /// True if poses in frame 0 have their origin at the root, in the axes of frame 0.
    pub from_root: bool,
    /// M of the joint's frame in the parent's, before the displacement.
    pub placement: Pose<Term<'g>>,
    /// Sine and cosine of the rotation.
    pub angle: (Term<'g>, Term<'g>),
    /// The translation \[m\].
    pub translation: Term<'g>,
    /// The displacement of a joint without an axis of its own, in place of both.
    pub displacement: Option<Pose<Term<'g>>>,
    /// True if the body before it, with the same frame, has the displacement of the joint.
    pub taken: bool,
    /// The axis of its frame; z for a joint with an axis of its own.
    pub axis: usize,
    /// L of the joint.
    pub screw: Screw<Term<'g>>,
    /// J of the body.
    pub inertia: Inertia<Term<'g>>,
    /// Armature, damping and friction.
    pub actuator: ActuatorTerms<Term<'g>>,
    /// The change of frame of inertias.
    pub congruence: Congruence,
}

/// The joints of all bodies.
pub type Joints<'g> = List<BodyId, DisplacedJoint<'g>>;

impl<'g> DisplacedJoint<'g> {
    /// The joint of body `k`, where `left` has the rotation that each body's frame leaves to its children.
    fn new(
        bodies: &Bodies<'g>,
        k: BodyId,
        state: &State<'g>,
        left: &List<BodyId, Option<AxisRotation<'g>>>,
        congruence: Congruence,
    ) -> Self {
        let body: &Body<'g> = &bodies.bodies[k];
        let graph = state.graph;
        let (zero, one) = (state.zero(), graph.constant(1.0));
        let outer = body.parent.and_then(|parent| left[parent]);
        let angle = match left[k] {
            Some(_) => (zero, one),
            None => axis_rotation::of_body(body, k, state, outer).sine_and_cosine(graph),
        };
        let translation = body.motion.translation(|| state.q(k)).unwrap_or(zero);
        let displacement = match body.position {
            Position::Manifold(manifold, first) => {
                Some(manifold.displacement(|entry| state.coordinate(first.plus(entry))))
            }
            Position::Along { .. } | Position::Taken => None,
        };
        let mut axis = [zero; 3];
        axis[body.axis] = one;
        let mut placement = body.placement;
        if let Some(outer) = outer {
            let rotation = Rotation::about_z(outer.sine_and_cosine(graph));
            placement.translation = rotation * placement.translation;
        }
        Self {
            body: k,
            parent: body.parent,
            motion: body.motion,
            frame: Frame::Link,
            from_root: false,
            placement,
            angle,
            translation,
            displacement,
            taken: matches!(body.position, Position::Taken),
            axis: body.axis,
            screw: body.motion.screw(Vector(axis)),
            inertia: match left[k] {
                Some(turn) => body.inertia.rotate_about_z(turn.sine_and_cosine(graph)),
                None => body.inertia,
            },
            actuator: body.actuator,
            congruence,
        }
    }

    /// The joint with all its matrices in frame 0, for a pose of its body: M L M⁻¹ and M J Mᵗ, as in the paper (eqs. 8
    /// and 17).
    fn in_frame_0(self, pose: Pose<Term<'g>>) -> Self {
        let graph = self.translation.graph();
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        let index = self.body.into();
        let screw = self.screw.change_frame(pose);
        let of = LabelledBodies::Body(index);
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
            translation: zero,
            displacement: None,
            screw,
            inertia,
            ..self
        }
    }

    /// M₀ of the body, where `outer` is that of its parent.
    fn pose(&self, outer: Pose<Term<'g>>) -> Pose<Term<'g>> {
        let pose = outer * self.placement * self.displacement();
        let of = LabelledBodies::FromBase(self.body.into());
        if !self.from_root {
            pose.translation.label(Block::Origin.of(of));
        }
        for k in 0..3 {
            pose.rotation.column(k).label(Block::Axis(k).of(of));
        }
        pose
    }

    /// Keeps the origin of a body at the root at that of frame 0; it only rotates there.
    fn stay(&mut self) {
        let zero = Vector::zero(self.translation.graph());
        self.placement.translation = zero;
        self.translation = zero.x();
        if let Some(displacement) = &mut self.displacement {
            displacement.translation = zero;
        }
    }

    /// True if its motion moves the screw of a joint `at` inboard of it: its own, and those of other velocities of
    /// the same joint.
    pub fn carries_screw(&self, at: BodyId, joints: &List<BodyId, Self>) -> bool {
        let mut own = successors(Some(self), |joint| {
            joint.parent.filter(|_| joint.taken).map(|k| &joints[k])
        });
        own.any(|joint| joint.body == at)
    }

    /// The numbers in names of its body and of the frame of its matrices; frame 0 is that of the base.
    pub fn numbers(&self) -> (Numeral, Numeral) {
        let body = self.body.into();
        match self.frame {
            Frame::Link => (body, body),
            Frame::Base => (body, Numeral::BASE),
        }
    }

    /// The number of the frame in which the matrices of the parent body are.
    pub fn outer_frame_number(&self) -> Numeral {
        match (self.frame, self.parent) {
            (Frame::Link, Some(parent)) => parent.into(),
            (Frame::Link, None) | (Frame::Base, _) => Numeral::BASE,
        }
    }

    /// The rotation as a matrix.
    pub fn turn(&self) -> Rotation<Term<'g>> {
        self.displacement.map_or_else(
            || Rotation::about_z(self.angle),
            |displacement| displacement.rotation,
        )
    }

    /// The translation as a vector.
    pub fn offset(&self) -> Vector<Term<'g>> {
        let zero = self.translation.graph().constant(0.0);
        let along_z = || Vector([zero, zero, self.translation]);
        self.displacement
            .map_or_else(along_z, |displacement| displacement.translation)
    }

    /// A vector in the parent's axes, from the body's.
    pub fn vector_inboard(&self, vector: Vector<Term<'g>>) -> Vector<Term<'g>> {
        self.placement.rotation * (self.turn() * vector)
    }

    /// A point in the parent's frame, from the body's.
    pub fn point_inboard(&self, point: Vector<Term<'g>>) -> Vector<Term<'g>> {
        self.placement.point(self.turn() * point + self.offset())
    }

    /// A vector in the body's axes, from the parent's.
    pub fn vector_outboard(&self, vector: Vector<Term<'g>>) -> Vector<Term<'g>> {
        self.turn().transposed() * (self.placement.rotation.transposed() * vector)
    }

    /// A motion of the parent body, in the body's frame.
    pub fn motion_outboard(&self, w: Velocity<Term<'g>>) -> Velocity<Term<'g>> {
        w.move_pole(self.placement.translation)
            .rotate(self.placement.rotation.transposed())
            .move_pole(self.offset())
            .rotate(self.turn().transposed())
    }

    /// A motion in the parent's frame, from the body's.
    pub fn motion_inboard(&self, w: Velocity<Term<'g>>) -> Velocity<Term<'g>> {
        w.change_frame(self.displacement())
            .change_frame(self.placement)
    }

    /// A wrench or momentum in the parent's frame, from the body's.
    pub fn action_inboard(&self, action: Action<Term<'g>>) -> Action<Term<'g>> {
        action
            .change_frame(self.displacement())
            .change_frame(self.placement)
    }

    /// First moments of a mass in the parent's frame, from the body's: R q + m p.
    pub fn first_moment_inboard(&self, q: Vector<Term<'g>>, mass: Term<'g>) -> Vector<Term<'g>> {
        let moved = self.turn() * q + self.offset() * mass;
        self.placement.rotation * moved + self.placement.translation * mass
    }

    /// J of the body in its parent's frame.
    pub fn inertia_inboard(&self, inertia: Inertia<Term<'g>>) -> Inertia<Term<'g>> {
        let moved = match self.displacement {
            Some(displacement) => inertia.change_frame(displacement),
            None => self.rotated(inertia).translate(self.offset()),
        };
        moved.change_frame(self.placement)
    }

    /// J of the body before the rotation of its joint, but after the translation.
    pub fn rotated(&self, inertia: Inertia<Term<'g>>) -> Inertia<Term<'g>> {
        match self.congruence {
            Congruence::Sparing => inertia.rotate_about_z(self.angle),
            Congruence::Full => inertia.rotate_in_full_about_z(self.angle),
        }
    }

    /// The displacement as a pose.
    pub fn displacement(&self) -> Pose<Term<'g>> {
        Pose {
            rotation: self.turn(),
            translation: self.offset(),
        }
    }
}

/// Joints, each with M₀ of its body; parents come before children.
pub(super) fn placed<'g>(
    joints: &[DisplacedJoint<'g>],
) -> Vec<(DisplacedJoint<'g>, Pose<Term<'g>>)> {
    let mut found: Vec<(DisplacedJoint<'g>, Pose<Term<'g>>)> = Vec::with_capacity(joints.len());
    for &joint in joints {
        let outer = (found.iter().rev()).find(|(outer, _)| Some(outer.body) == joint.parent);
        let base = || Pose::identity(joint.translation.graph());
        let pose = joint.pose(outer.map_or_else(base, |&(_, pose)| pose));
        found.push((joint, pose));
    }
    found
}

/// Joints with all their matrices in frame 0, of all bodies or of some.
pub fn in_frame_0<'g, J: FromIterator<DisplacedJoint<'g>>>(joints: &[DisplacedJoint<'g>]) -> J {
    let placed = placed(joints).into_iter();
    placed.map(|(joint, pose)| joint.in_frame_0(pose)).collect()
}

/// The rotation that the frame of each body leaves to its children, if all joints are included.
pub(super) fn left<'g>(
    bodies: &Bodies<'g>,
    state: &State<'g>,
    algorithm: Algorithm,
) -> List<BodyId, Option<AxisRotation<'g>>> {
    axis_rotation::left_to_carried(bodies, state, algorithm.angles, |k| {
        let mut carried = bodies
            .bodies
            .iter()
            .filter(|body| body.parent == Some(k))
            .peekable();
        carried.peek().is_some() && carried.all(axis_rotation::is_parallel)
    })
}

/// All joints, in the order of the bodies.
pub fn joints<'g>(bodies: &Bodies<'g>, state: &State<'g>, algorithm: Algorithm) -> Joints<'g> {
    let left = left(bodies, state, algorithm);
    let all = bodies.bodies.ids();
    all.map(|k| DisplacedJoint::new(bodies, k, state, &left, algorithm.congruence))
        .collect()
}

/// The same joints and base, with another origin of frame 0: at the body at the root if there is only one and it
/// carries all mass, or else at the placement of the first root.
pub fn from_root<'g>(
    mut joints: Joints<'g>,
    base: Inertia<Term<'g>>,
) -> (Joints<'g>, Inertia<Term<'g>>) {
    for joint in &mut joints {
        joint.from_root = true;
    }
    let mut roots: Vec<&mut DisplacedJoint<'g>> = joints
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

/// The path from the base to a frame.
pub struct Path<'g> {
    /// The frame of the matrices of its joints.
    pub frame: Frame,
    /// The joints that move the frame, from the base outwards.
    pub joints: Vec<DisplacedJoint<'g>>,
    /// Number of joints of the robot.
    pub count: usize,
    /// M of the frame in the last body's, or M₀ of the frame if all matrices are in frame 0.
    pub end: Pose<Term<'g>>,
}

impl<'g> Path<'g> {
    /// The joints from the base outwards, each with M₀ of its body.
    pub fn outwards(&self) -> Vec<(DisplacedJoint<'g>, Pose<Term<'g>>)> {
        placed(&self.joints)
    }

    /// The joints from the base outwards, each with M₀ of its body but with the origin at that of the frame at the end.
    ///
    /// The offsets between them are summed. A difference of two offsets from the base would lose the digits of short
    /// ones.
    pub fn outwards_from_end(&self) -> Vec<(DisplacedJoint<'g>, Pose<Term<'g>>)> {
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

    /// The joints from the frame inwards, each with M of its body in the frame.
    pub fn inwards(&self) -> Vec<(DisplacedJoint<'g>, Pose<Term<'g>>)> {
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

    /// The path with all its matrices in frame 0.
    pub fn in_frame_0(self) -> Self {
        Self {
            frame: Frame::Base,
            joints: in_frame_0(&self.joints),
            end: self.pose(),
            ..self
        }
    }
}

/// The path to a frame.
pub fn path<'g>(
    bodies: &Bodies<'g>,
    frame: FrameId,
    state: &State<'g>,
    algorithm: Algorithm,
) -> Path<'g> {
    path_beyond(bodies, None, frame, state, algorithm)
}

/// The last body that carries all of some frames; `None` for the base.
pub fn carrier(bodies: &Bodies<'_>, frames: impl IntoIterator<Item = FrameId>) -> Option<BodyId> {
    let inwards = |frame: FrameId| successors(bodies.frames[frame].0, |&k| bodies.bodies[k].parent);
    let mut frames = frames.into_iter();
    let mut common: Vec<BodyId> = inwards(frames.next()?).collect();
    for frame in frames {
        let other: Vec<BodyId> = inwards(frame).collect();
        common.retain(|k| other.contains(k));
    }
    common.first().copied()
}

/// The path to a frame from a body that carries it, or from the base; its first placement is relative to that.
pub fn path_beyond<'g>(
    bodies: &Bodies<'g>,
    from: Option<BodyId>,
    frame: FrameId,
    state: &State<'g>,
    algorithm: Algorithm,
) -> Path<'g> {
    let (last, end) = bodies.frames[frame];
    let inwards = || {
        let all = successors(last, |&k| bodies.bodies[k].parent);
        all.take_while(|&k| Some(k) != from)
    };
    let left = axis_rotation::left_to_carried(bodies, state, algorithm.angles, |k| {
        let next = inwards().find(|&next| bodies.bodies[next].parent == Some(k));
        Some(k) != from && next.is_some_and(|next| axis_rotation::is_parallel(&bodies.bodies[next]))
    });
    let joints =
        inwards().map(|k| DisplacedJoint::new(bodies, k, state, &left, algorithm.congruence));
    let mut joints: Vec<DisplacedJoint<'g>> = joints.collect();
    joints.reverse();
    Path {
        frame: Frame::Link,
        joints,
        count: bodies.bodies.len(),
        end,
    }
}
