//! Steps of a robot some of whose coordinates are no angles and shifts: from a posture by velocities, and
//! from one posture to another.
//!
//! In: a [`Module`]. Out: which functions of postures it has, and what they are called, take and return in
//! any language. Robots whose coordinates are all added to have none.

use crate::module::{DataMotion, Module};
use crate::space::Space;

/// A function of postures alone.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    /// Where velocities lead.
    Integrate,
    /// Which velocities lead from one posture to another.
    Difference,
    /// Which posture is meant by coordinates.
    Normalize,
}

impl Step {
    /// Those of a robot.
    pub fn of(module: &Module) -> &'static [Self] {
        let is_posture = |motion: &DataMotion| matches!(motion, DataMotion::Posture(_));
        if module.data.motions.iter().any(is_posture) {
            &[Self::Integrate, Self::Difference, Self::Normalize]
        } else {
            &[]
        }
    }

    pub const fn name(self) -> &'static str {
        match self {
            Self::Integrate => "integrate",
            Self::Difference => "difference",
            Self::Normalize => "normalize",
        }
    }

    /// What it tells.
    pub const fn about(self) -> [&'static str; 2] {
        match self {
            Self::Integrate => [
                "Where the robot gets to from `q` with velocities kept for one unit of time; of a time Δt, `v` is q̇ Δt.",
                "Bodies whose velocities are seen in their own axes move along the screw that they keep.",
            ],
            Self::Difference => [
                "The velocities that lead from `q0` to `q1` in one unit of time.",
                "Turns of bodies whose velocities are seen in their own axes are the shortest, half a turn at most.",
            ],
            Self::Normalize => [
                "The same coordinates with quaternions of length 1.",
                "None of them may be zero.",
            ],
        }
    }

    /// Its arguments, and what entries each has.
    pub const fn arguments(self) -> &'static [(&'static str, Space)] {
        match self {
            Self::Integrate => &[("q", Space::Coordinates), ("v", Space::Velocities)],
            Self::Difference => &[("q0", Space::Coordinates), ("q1", Space::Coordinates)],
            Self::Normalize => &[("q", Space::Coordinates)],
        }
    }

    /// What entries its result has.
    pub const fn result(self) -> Space {
        match self {
            Self::Integrate | Self::Normalize => Space::Coordinates,
            Self::Difference => Space::Velocities,
        }
    }
}
