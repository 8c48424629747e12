//! A robot, link by link, as matrices of numbers.

use super::{Approximate, Matrix};
use crate::closure::Row;
use crate::expression::Double;
use crate::joint::Posture;
use crate::list::{List, id};
use crate::space::{CoordinateId, FrameId, ParameterId, VelocityId};

id! {
    /// The number of a body among those of a [`Robot`]: one for each link, and for what is held between them.
    BodyId
}

/// What a link hangs on, and by which motion.
pub(crate) struct Body {
    /// The body it hangs on; none of those that hang on the base.
    pub(crate) parent: Option<BodyId>,
    /// M of the joint's frame in the parent link's, at q = 0.
    pub(crate) placement: Matrix<Approximate>,
    /// Where the joint has taken it from there.
    pub(crate) moved: Moved,
    /// How it moves on.
    pub(crate) freedoms: Vec<Freedom>,
    /// J of the link in its frame.
    pub(crate) inertia: Matrix<Approximate>,
}

/// A screw, in the link's frame, and the velocity that it goes with.
pub(crate) struct Freedom {
    /// u and b.
    pub(crate) screw: [[Approximate; 3]; 2],
    /// The velocity's place in q̇.
    pub(crate) velocity: VelocityId,
    /// What the velocity is multiplied by.
    pub(crate) factor: Approximate,
    /// Armature, damping and friction.
    pub(crate) drive: [Approximate; 3],
}

/// What says how far a joint is displaced.
pub(crate) enum Moved {
    /// An entry of q, times a factor, and an offset: so far along a screw.
    By {
        /// u and b in the link's frame.
        screw: [[Approximate; 3]; 2],
        /// The entry.
        coordinate: CoordinateId,
        /// What it is multiplied by.
        factor: Approximate,
        /// What is added then.
        offset: Approximate,
    },
    /// The entries of q from here on.
    Posture(Posture, CoordinateId),
    /// Nothing: it stays so far along a screw.
    Held([[Approximate; 3]; 2], Double),
}

/// A joint that closes a loop.
pub(crate) struct Closed {
    /// The frames that it holds together, among those of the robot.
    pub(crate) frames: [FrameId; 2],
    /// What it closes.
    pub(crate) rows: Vec<Row>,
    /// The length of a rod, or the cosine of the angle of two axes.
    pub(crate) size: Approximate,
}

/// A robot, link by link, parents before children.
pub(crate) struct Robot {
    pub(crate) bodies: List<BodyId, Body>,
    /// How many velocities it has.
    pub(crate) velocities: usize,
    /// Acceleration of gravity in frame 0.
    pub(crate) gravity: [Approximate; 3],
    /// The bodies whose frames are asked for, and behind them those of loops; none for the base.
    pub(crate) frames: List<FrameId, Option<BodyId>>,
    /// The bodies that joints move as links, in the order of their coordinates.
    pub(crate) links: Vec<BodyId>,
    /// The columns of the regressor that the base regressor has, where base parameters are asked for.
    pub(crate) base_columns: Vec<ParameterId>,
    /// The bodies of each joint of whose drive the regressor has columns behind those of links.
    pub(crate) identified: Vec<Vec<BodyId>>,
    /// The loops.
    pub(crate) loops: Vec<Closed>,
    /// The velocities that are driven, where loops move the others.
    pub(crate) actuated: Vec<VelocityId>,
    /// The bodies on which something acts from outside, and whether that is in frame 0 and not in theirs.
    pub(crate) external: (Vec<BodyId>, bool),
}

/// A matrix over velocities and parameters by its columns.
pub(crate) type Columns<T> = List<ParameterId, List<VelocityId, T>>;
