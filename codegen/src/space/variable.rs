//! What an argument of a generated function holds: a number for each entry of a space.

use super::{Kind, Space};

/// An argument of a generated function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Variable {
    /// Joint coordinates [rad or m].
    Q,
    /// Their rates [rad/s or m/s].
    Qd,
    /// Their second rates [rad/s² or m/s²].
    Qdd,
    /// Joint torques and forces \[N m or N\].
    Tau,
    /// What the surroundings exert on links \[N m and N\].
    Actions,
}

impl Variable {
    /// All of them, in the order in which functions take them.
    pub const ALL: [Self; 5] = [Self::Q, Self::Qd, Self::Qdd, Self::Tau, Self::Actions];

    /// Its name in generated code and in state files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Q => "q",
            Self::Qd => "qd",
            Self::Qdd => "qdd",
            Self::Tau => "tau",
            Self::Actions => "actions",
        }
    }

    /// Its letter in sentences.
    #[must_use]
    pub const fn letter(self) -> &'static str {
        match self {
            Self::Q => "q",
            Self::Qd => "q̇",
            Self::Qdd => "q̈",
            Self::Tau => "τ",
            Self::Actions => "Φ",
        }
    }

    /// What it lists a number for each entry of.
    #[must_use]
    pub const fn space(self) -> Space {
        match self {
            Self::Q => Space::Coordinates,
            Self::Qd | Self::Qdd | Self::Tau => Space::Velocities,
            Self::Actions => Space::Actions,
        }
    }

    /// The unit of an entry.
    #[must_use]
    pub const fn unit(self, kind: Kind) -> &'static str {
        match (self, kind) {
            (Self::Q, Kind::Turn) => "rad",
            (Self::Q, Kind::Slide) => "m",
            (_, Kind::Quaternion) => "1",
            (Self::Qd, Kind::Turn) => "rad/s",
            (Self::Qd, Kind::Slide) => "m/s",
            (Self::Qdd, Kind::Turn) => "rad/s²",
            (Self::Qdd, Kind::Slide) => "m/s²",
            (Self::Tau | Self::Actions, Kind::Turn) => "N m",
            (Self::Tau | Self::Actions, Kind::Slide) => "N",
            (_, Kind::Moment(_) | Kind::Drive { .. }) => panic!("no argument is over parameters"),
        }
    }

    /// All that some functions together are functions of, in the order of the parameters.
    #[must_use]
    pub fn together(each: impl IntoIterator<Item = Vec<Self>>) -> Vec<Self> {
        let mut all: Vec<Self> = each.into_iter().flatten().collect();
        all.sort_unstable();
        all.dedup();
        all
    }
}
