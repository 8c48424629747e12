//! A joint as data, and its type of motion.
//!
//! In: a placement, a screw or another type of motion, an inertia. Out: a [`Joint`] of a
//! [`Chain`](crate::Chain), as a constant, and the numbers of coordinates and velocities of each [`Motion`].
//! [`crate::generic`] and [`manifold`](super::manifold) compute the motion itself.

use super::actuator::{JointActuator, VELOCITIES};
use crate::matrix::{Inertia, Pose, Screw};

/// A joint and the body that it carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Its name.
    pub name: &'static str,
    /// The index of the parent joint, whose body carries this joint; `None` is the base.
    pub parent: Option<usize>,
    /// M_parent,i in the neutral configuration \[m\].
    pub placement: Pose<f64>,
    /// L of the joint, in frame (i); zero for planar, spherical and floating joints.
    pub screw: Screw<f64>,
    /// Its type of motion.
    pub motion: Motion,
    /// J of body i, in frame (i).
    pub inertia: Inertia<f64>,
    /// Armature and friction of each of its velocities, in their order; [`JointActuator::NONE`] behind the last.
    pub actuators: [JointActuator; VELOCITIES],
}

/// The type of motion of a joint, with its coordinates (entries of q) and velocities (entries of q̇).
///
/// The velocities of [`Planar`](Self::Planar), [`Spherical`](Self::Spherical) and
/// [`Floating`](Self::Floating) are those of the body in its own moved frame (i), not the derivatives of the
/// coordinates: W of the joint is Σ L q̇ with screws L that are constant in frame (i). The layouts of the
/// last two are Pinocchio's.
///
/// A quaternion v, w means R = I + 2 w v̲ + 2 v̲² and should have length 1. At length 1 + ε the result is R at
/// length 1 plus (2ε + ε²) (R − I): the error of a column is at most 4ε, to the first order, and largest for
/// rotations by 180°. [`Chain::normalize`](crate::Chain::normalize) restores the length.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Motion {
    /// Revolute, prismatic or helical: along its screw, with one coordinate \[rad or m\] and its rate.
    Along,
    /// Mimic joint: along its screw by `multiplier` times the coordinate of the mimicked joint. It has no
    /// coordinate of its own.
    Mimic {
        /// The index of the mimicked joint, which moves along a screw.
        mimicked: usize,
        /// Factor of the coordinate, of its rates, and of the torque on the mimicked joint.
        multiplier: f64,
    },
    /// In the plane z = 0 of the placement. Coordinates x, y \[m\] and the angle about z \[rad\]; velocities v_x, v_y
    /// in the moved frame \[m/s\] and ω_z \[rad/s\].
    Planar,
    /// Any rotation. Coordinates are the quaternion x, y, z, w; velocities ω in the moved frame \[rad/s\].
    Spherical,
    /// Any displacement. Coordinates x, y, z \[m\] and the quaternion x, y, z, w; velocities v \[m/s\] and ω \[rad/s\] in
    /// the moved frame.
    Floating,
}

impl Joint {
    /// A joint that moves along a screw: `placement` is M_parent,i at q = 0, `screw` its L in frame (i),
    /// `inertia` the J of body i in frame (i). It has neither armature nor friction.
    #[inline]
    #[must_use]
    pub const fn new(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        screw: Screw<f64>,
        inertia: Inertia<f64>,
    ) -> Self {
        Self {
            name,
            parent,
            placement,
            screw,
            motion: Motion::Along,
            inertia,
            actuators: [JointActuator::NONE; VELOCITIES],
        }
    }

    /// The same joint as a mimic joint: it moves by `multiplier` times the coordinate of joint `mimicked`, and is
    /// at its placement where that coordinate is zero.
    #[inline]
    #[must_use]
    pub const fn mimic(self, mimicked: usize, multiplier: f64) -> Self {
        Self {
            motion: Motion::Mimic {
                mimicked,
                multiplier,
            },
            ..self
        }
    }

    /// The same joint with armature and friction at its velocity of index `velocity`; of a mimic joint, at its
    /// own rate. An index that the joint does not have changes nothing.
    #[inline]
    #[must_use]
    pub const fn with_actuator(mut self, velocity: usize, actuator: JointActuator) -> Self {
        if velocity < VELOCITIES {
            self.actuators[velocity] = actuator;
        }
        self
    }

    /// A planar joint: translation in the plane z = 0 of `placement`, rotation about its z axis.
    #[inline]
    #[must_use]
    pub const fn planar(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        inertia: Inertia<f64>,
    ) -> Self {
        Self::with_manifold(name, parent, placement, Motion::Planar, inertia)
    }

    /// A spherical joint: any rotation about the origin of `placement`.
    #[inline]
    #[must_use]
    pub const fn spherical(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        inertia: Inertia<f64>,
    ) -> Self {
        Self::with_manifold(name, parent, placement, Motion::Spherical, inertia)
    }

    /// A floating joint: any displacement from `placement`.
    #[inline]
    #[must_use]
    pub const fn floating(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        inertia: Inertia<f64>,
    ) -> Self {
        Self::with_manifold(name, parent, placement, Motion::Floating, inertia)
    }

    const fn with_manifold(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        motion: Motion,
        inertia: Inertia<f64>,
    ) -> Self {
        Self {
            name,
            parent,
            placement,
            screw: Screw::new([0.0; 3], [0.0; 3]),
            motion,
            inertia,
            actuators: [JointActuator::NONE; VELOCITIES],
        }
    }
}

impl Motion {
    /// Number of its own entries of q.
    #[must_use]
    pub const fn coordinates(self) -> usize {
        match self {
            Self::Along => 1,
            Self::Mimic { .. } => 0,
            Self::Planar => 3,
            Self::Spherical => 4,
            Self::Floating => 7,
        }
    }

    /// Number of its own entries of q̇.
    #[must_use]
    pub const fn velocities(self) -> usize {
        match self {
            Self::Along => 1,
            Self::Mimic { .. } => 0,
            Self::Planar | Self::Spherical => 3,
            Self::Floating => 6,
        }
    }
}
