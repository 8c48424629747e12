//! One algorithm among several that compute the same: frames, sums of angles, and the form of forward dynamics.

pub use crate::formulation::{Angles, Forward, Frame};
use crate::real::Real;

/// One algorithm among several that compute the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Algorithm {
    /// The frame of the recursions; that of articulated bodies runs in the frames of the links.
    pub frame: Frame,
    /// Sums of the angles of parallel axes, or products of their rotations.
    pub angles: Angles,
    /// The direction in which the pose of a frame is computed.
    pub pose: Carried,
    /// The form of forward dynamics.
    pub forward: Forward,
    /// The change of frame of composite inertias.
    pub congruence: Congruence,
    /// The type of numbers, which determines the threshold of zero pivots.
    pub scalar: Real,
}

/// The number of products for the rotation of an inertia's block in the plane across an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Congruence {
    /// Four. The smaller moment is computed by subtraction from the larger one, and has its rounding error.
    Sparing,
    /// All. Each moment is a sum of its own, which keeps the digits of the small one: for slender links, and wherever
    /// M is inverted.
    Full,
}

/// The direction in which the pose of a frame is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carried {
    /// From the frame to the base, by columns.
    Inwards {
        /// The column that is the product of the two others, which alone are passed on; `None` if all are.
        by_product: Option<usize>,
    },
    /// From the base to the frame, like the Jacobians, with which it then shares operations.
    Outwards,
}

impl Algorithm {
    /// All columns passed inwards, accelerations by the mass matrix.
    pub const PLAIN: Self = Self {
        frame: Frame::Link,
        angles: Angles::Apart,
        pose: Carried::Inwards { by_product: None },
        forward: Forward::UNREFINED,
        scalar: Real::Generic,
        congruence: Congruence::Sparing,
    };

    /// Everything in frame 0, accelerations by the mass matrix.
    pub const IN_FRAME_0: Self = Self {
        frame: Frame::Base,
        pose: Carried::Outwards,
        ..Self::PLAIN
    };
}
