//! A joint as data, and what it allows.
//!
//! In: a placement, a screw or the kind of a posture, an inertia. Out: a [`Joint`] of a
//! [`Chain`](crate::Chain), as a constant, and how many coordinates and velocities each [`Motion`] has.
//! Where a body goes is for [`crate::generic`] and [`posture`](super::posture).

use super::drive::{Drive, VELOCITIES};
use crate::matrix::{Inertia, Pose, Screw};

/// A joint and the body that it carries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Its name.
    pub name: &'static str,
    /// The joint that carries the body it stands on; `None` is the base.
    pub parent: Option<usize>,
    /// M_parent,i where the joint is neutral \[m\].
    pub placement: Pose<f64>,
    /// L of the joint, in frame (i); zero where its motion is no screw's.
    pub screw: Screw<f64>,
    /// What it allows.
    pub motion: Motion,
    /// J of body i, in frame (i).
    pub inertia: Inertia<f64>,
    /// What drives each of its velocities, in their order; none behind the last.
    pub drives: [Drive; VELOCITIES],
}

/// What a joint allows, and what its entries of q and q̇ are.
///
/// The velocities of [`Planar`](Self::Planar), [`Spherical`](Self::Spherical) and
/// [`Floating`](Self::Floating) are those of the body in its own moved frame (i), and no derivatives of the
/// coordinates: W of the joint is Σ L q̇ with screws L that are constant in frame (i). The layouts of the
/// last two are Pinocchio's.
///
/// A quaternion v, w stands for R = I + 2 w v̲ + 2 v̲² and is taken to have length 1. Of length 1 + ε that is
/// R at length 1 plus (2ε + ε²) (R − I): no column is off by more than 4ε, to the first order, and turns of
/// half a circle are distorted most. [`Chain::normalize`](crate::Chain::normalize) mends it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Motion {
    /// Along its screw, by one coordinate \[rad or m\] and its rate.
    Along,
    /// Along its screw, by the coordinate of joint `leader` times `multiplier`: it has none of its own.
    Following {
        /// The joint that has the coordinate, which moves along a screw.
        leader: usize,
        /// What the coordinate, its rates and the force it sends back are multiplied by.
        multiplier: f64,
    },
    /// In the plane z = 0 of the parent: x, y \[m\] and the angle about z \[rad\]; v_x, v_y in the
    /// moved frame, ω_z.
    Planar,
    /// Any turn: the quaternion x, y, z, w; ω in the moved frame.
    Spherical,
    /// Any displacement: x, y, z \[m\] and the quaternion x, y, z, w; v and ω in the moved frame.
    Floating,
}

impl Joint {
    /// A joint that moves along a screw: `placement` is M_parent,i at q = 0, `screw` its L in frame (i),
    /// `inertia` the J of body i in frame (i). It has no drives.
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
            drives: [Drive::NONE; VELOCITIES],
        }
    }

    /// The same joint without a coordinate of its own: that of joint `leader` moves it, `multiplier` times
    /// as far. Where the leader's coordinate is zero it is at its placement.
    #[inline]
    #[must_use]
    pub const fn following(self, leader: usize, multiplier: f64) -> Self {
        Self {
            motion: Motion::Following { leader, multiplier },
            ..self
        }
    }

    /// The same joint with a drive on the velocity of that index among its own; of a joint that follows
    /// another, on its own rate. Nothing is driven where it has no such velocity.
    #[inline]
    #[must_use]
    pub const fn with_drive(mut self, velocity: usize, drive: Drive) -> Self {
        if velocity < VELOCITIES {
            self.drives[velocity] = drive;
        }
        self
    }

    /// A joint that slides in the plane z = 0 of `placement`, and turns about its z axis.
    #[inline]
    #[must_use]
    pub const fn planar(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        inertia: Inertia<f64>,
    ) -> Self {
        Self::postured(name, parent, placement, Motion::Planar, inertia)
    }

    /// A joint that turns in any way about the origin of `placement`.
    #[inline]
    #[must_use]
    pub const fn spherical(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        inertia: Inertia<f64>,
    ) -> Self {
        Self::postured(name, parent, placement, Motion::Spherical, inertia)
    }

    /// A joint that allows any motion, and counts it from `placement` on.
    #[inline]
    #[must_use]
    pub const fn floating(
        name: &'static str,
        parent: Option<usize>,
        placement: Pose<f64>,
        inertia: Inertia<f64>,
    ) -> Self {
        Self::postured(name, parent, placement, Motion::Floating, inertia)
    }

    const fn postured(
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
            drives: [Drive::NONE; VELOCITIES],
        }
    }
}

impl Motion {
    /// How many entries of q it has of its own.
    #[must_use]
    pub const fn coordinates(self) -> usize {
        match self {
            Self::Along => 1,
            Self::Following { .. } => 0,
            Self::Planar => 3,
            Self::Spherical => 4,
            Self::Floating => 7,
        }
    }

    /// How many entries of q̇ it has of its own.
    #[must_use]
    pub const fn velocities(self) -> usize {
        match self {
            Self::Along => 1,
            Self::Following { .. } => 0,
            Self::Planar | Self::Spherical => 3,
            Self::Floating => 6,
        }
    }
}
