//! One of several ways to compute the same: which frames, which angles, which form.

pub use crate::formulation::{Angles, Forward, Frame};
use crate::real::Real;

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
    /// The type of number that it is computed in, which decides what is nothing beside something else.
    pub scalar: Real,
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
        scalar: Real::Generic,
    };

    /// Everything in frame 0, accelerations by the mass matrix.
    pub const IN_FRAME_0: Self = Self {
        frame: Frame::Base,
        pose: Carried::Outwards,
        ..Self::PLAIN
    };
}
