//! One of several ways to compute the same: which frames, which angles, which form.

pub use crate::formulation::{Angles, Forward, Frame};

/// One of several ways to compute the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Way {
    /// The frame in which the recursions run; the articulated bodies' are those of the links.
    pub frame: Frame,
    /// Whether the angles of parallel axes are summed.
    pub angles: Angles,
    /// How the pose of a frame is found.
    pub pose: Carried,
    /// How accelerations are found from forces.
    pub forward: Forward,
    /// How the inertias of composite bodies turn with their joints.
    pub congruence: Congruence,
}

/// With how many products the plane block of an inertia turns about an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Congruence {
    /// With four, which subtract from the larger moment to have the smaller: what is left has the error of the
    /// larger one.
    Sparing,
    /// With all, so that each moment is summed of its own: of slender links, and wherever M is solved with, this
    /// keeps the digits of the small one.
    Full,
}

/// How the pose of a frame is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carried {
    /// From the frame to the base, column by column.
    Inwards {
        /// Which column is made from the two others, which alone are carried; none where all are.
        by_product: Option<usize>,
    },
    /// From the base to the frame, as the Jacobians are, with which it then shares the work.
    Outwards,
}

impl Way {
    /// Columns all carried inwards, accelerations by the mass matrix.
    pub const PLAIN: Self = Self {
        frame: Frame::Link,
        angles: Angles::Apart,
        pose: Carried::Inwards { by_product: None },
        forward: Forward::UNREFINED,
        congruence: Congruence::Sparing,
    };

    /// Everything in frame 0, accelerations by the mass matrix.
    pub const IN_FRAME_0: Self = Self {
        frame: Frame::Base,
        pose: Carried::Outwards,
        ..Self::PLAIN
    };
}
