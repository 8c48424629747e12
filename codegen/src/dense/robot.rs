//! A robot, link by link, as matrices of numbers.

use super::{Approximate, Matrix};
use crate::closure::ResidualKind;
use crate::expression::Double;
use crate::joint::Manifold;
use crate::list::{List, id};
use crate::space::{CoordinateId, FrameId, ParameterId, SphereId, VelocityId};

id! {
    /// The number of a body of a [`Robot`]: one for each link, and for each frame or motion between them.
    BodyId
}

/// A link with its joint.
pub(crate) struct DenseBody {
    /// The parent body; `None` for one on the base.
    pub(crate) parent: Option<BodyId>,
    /// M of the joint's frame in the parent link's, at q = 0.
    pub(crate) placement: Matrix<Approximate>,
    /// The displacement of the joint.
    pub(crate) moved: Moved,
    /// The degrees of freedom of the joint.
    pub(crate) degrees_of_freedom: Vec<DegreeOfFreedom>,
    /// J of the link in its frame.
    pub(crate) inertia: Matrix<Approximate>,
}

/// A degree of freedom: a screw, in the link's frame, with its velocity.
pub(crate) struct DegreeOfFreedom {
    /// u and b.
    pub(crate) screw: [[Approximate; 3]; 2],
    /// The velocity's index in q̇.
    pub(crate) velocity: VelocityId,
    /// Factor of the velocity.
    pub(crate) factor: Approximate,
    /// Armature, damping and friction.
    pub(crate) actuator: [Approximate; 3],
}

/// The coordinates of a joint's displacement.
pub(crate) enum Moved {
    /// An entry of q, times a factor, plus an offset, along a screw.
    By {
        /// u and b in the link's frame.
        screw: [[Approximate; 3]; 2],
        /// The entry.
        coordinate: CoordinateId,
        /// The factor.
        factor: Approximate,
        /// The offset.
        offset: Approximate,
    },
    /// The entries of q from here on.
    Manifold(Manifold, CoordinateId),
    /// None: it is held at a coordinate along a screw.
    Held([[Approximate; 3]; 2], Double),
}

/// A joint that closes a loop.
pub(crate) struct Closed {
    /// Its frames A and B, among those of the robot.
    pub(crate) frames: [FrameId; 2],
    /// Its residuals.
    pub(crate) rows: Vec<ResidualKind>,
    /// The length of a rod, or the cosine of the angle between two axes.
    pub(crate) size: Approximate,
}

/// A robot, link by link, parents before children.
pub(crate) struct Robot {
    pub(crate) bodies: List<BodyId, DenseBody>,
    /// The number of velocities.
    pub(crate) velocities: usize,
    /// Acceleration of gravity in frame 0.
    pub(crate) gravity: [Approximate; 3],
    /// The bodies of the requested frames, followed by those of wrenches, loops and spheres; `None` for the base.
    pub(crate) frames: List<FrameId, Option<BodyId>>,
    /// The number of requested frames.
    pub(crate) requested: usize,
    /// The bodies that joints move as links, in the order of their coordinates.
    pub(crate) links: Vec<BodyId>,
    /// The columns of the base regressor, as columns of the regressor, if base parameters are requested.
    pub(crate) base_columns: Vec<ParameterId>,
    /// The bodies of each joint whose armature, damping and friction have columns of the regressor after those of
    /// links.
    pub(crate) identified: Vec<Vec<BodyId>>,
    /// The frame and the radius \[m\] of each collision sphere.
    pub(crate) spheres: List<SphereId, (FrameId, Approximate)>,
    /// The pairs of spheres that have distances.
    pub(crate) pairs: Vec<[SphereId; 2]>,
    /// The loops.
    pub(crate) loops: Vec<Closed>,
    /// The residuals of all loops in the order in which they are eliminated.
    pub(crate) elimination: Vec<usize>,
    /// The velocities with an actuator, if loops move the others.
    pub(crate) actuated: Vec<VelocityId>,
    /// The bodies with an external wrench; true if the wrenches are in frame 0 instead of the body's frame.
    pub(crate) external: (Vec<BodyId>, bool),
}

/// A matrix over velocities and parameters by its columns.
pub(crate) type Columns<T> = List<ParameterId, List<VelocityId, T>>;
