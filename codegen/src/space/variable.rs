//! Arguments of generated functions: a number for each entry of a space.

use std::f64::consts::PI;
use std::ops::{Index, IndexMut};

use super::{Kind, Space};

/// An argument of a generated function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Variable {
    /// Configuration q [rad or m].
    Q,
    /// Velocities q̇ [rad/s or m/s].
    Qd,
    /// Accelerations q̈ [rad/s² or m/s²].
    Qdd,
    /// Joint torques and forces \[N m or N\].
    Tau,
    /// Weights λ of results: of joint torques and forces as a virtual displacement [rad or m], of joint accelerations
    /// as torques and forces \[N m or N\].
    Weights,
    /// Change δq of the configuration along the velocities: a direction of derivatives [rad or m].
    QChange,
    /// Change δq̇ of the velocities [rad/s or m/s].
    QdChange,
    /// Change δq̈ of the accelerations [rad/s² or m/s²].
    QddChange,
    /// Change δτ of the joint torques and forces \[N m or N\].
    TauChange,
    /// Weights λ of the twist of a frame: a wrench at its origin, in the axes of frame 0 \[N m and N\].
    Wrench,
    /// External wrenches on links \[N m and N\].
    Actions,
}

impl Variable {
    /// All arguments, in the order of parameters.
    pub const ALL: [Self; 11] = [
        Self::Q,
        Self::Qd,
        Self::Qdd,
        Self::Tau,
        Self::Weights,
        Self::QChange,
        Self::QdChange,
        Self::QddChange,
        Self::TauChange,
        Self::Wrench,
        Self::Actions,
    ];

    /// Name in generated code and in state files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Q => "q",
            Self::Qd => "qd",
            Self::Qdd => "qdd",
            Self::Tau => "tau",
            Self::Weights => "weights",
            Self::QChange => "q_change",
            Self::QdChange => "qd_change",
            Self::QddChange => "qdd_change",
            Self::TauChange => "tau_change",
            Self::Wrench => "wrench",
            Self::Actions => "actions",
        }
    }

    /// Letter in sentences.
    #[must_use]
    pub const fn letter(self) -> &'static str {
        match self {
            Self::Q => "q",
            Self::Qd => "q̇",
            Self::Qdd => "q̈",
            Self::Tau => "τ",
            Self::Weights => "λ",
            Self::QChange => "δq",
            Self::QdChange => "δq̇",
            Self::QddChange => "δq̈",
            Self::TauChange => "δτ",
            Self::Wrench | Self::Actions => "Φ",
        }
    }

    /// Space of its entries.
    #[must_use]
    pub const fn space(self) -> Space {
        match self {
            Self::Q => Space::Coordinates,
            Self::Qd
            | Self::Qdd
            | Self::Tau
            | Self::Weights
            | Self::QChange
            | Self::QdChange
            | Self::QddChange
            | Self::TauChange => Space::Velocities,
            Self::Wrench => Space::Wrench,
            Self::Actions => Space::Actions,
        }
    }

    /// Unit of an entry; that of weights depends on the function.
    #[must_use]
    pub const fn unit(self, kind: Kind) -> &'static str {
        match (self, kind) {
            (Self::Q | Self::QChange, Kind::Rotation) => "rad",
            (Self::Q | Self::QChange, Kind::Translation) => "m",
            (_, Kind::Quaternion) | (Self::Weights, _) => "1",
            (Self::Qd | Self::QdChange, Kind::Rotation) => "rad/s",
            (Self::Qd | Self::QdChange, Kind::Translation) => "m/s",
            (Self::Qdd | Self::QddChange, Kind::Rotation) => "rad/s²",
            (Self::Qdd | Self::QddChange, Kind::Translation) => "m/s²",
            (Self::Tau | Self::TauChange | Self::Wrench | Self::Actions, Kind::Rotation) => "N m",
            (Self::Tau | Self::TauChange | Self::Wrench | Self::Actions, Kind::Translation) => "N",
            (_, Kind::Moment(_) | Kind::Actuator { .. } | Kind::Frame) => {
                panic!("no argument is over parameters, frames or spheres")
            }
        }
    }

    /// True if its entries are those of wrenches: a couple, then a force.
    #[must_use]
    pub const fn has_wrenches(self) -> bool {
        matches!(self, Self::Wrench | Self::Actions)
    }

    /// True if it is a change of another argument.
    #[must_use]
    pub const fn is_change(self) -> bool {
        matches!(
            self,
            Self::QChange | Self::QdChange | Self::QddChange | Self::TauChange
        )
    }

    /// True if descriptions may limit it: q and q̇.
    #[must_use]
    pub const fn has_limits(self) -> bool {
        matches!(self, Self::Q | Self::Qd)
    }

    /// Magnitude that is assumed if the description has no limits: q within π rad or 1 m, q̇ within 10 rad/s or 1 m/s,
    /// q̈ within 10 rad/s² or 10 m/s², weights and changes within 1, wrenches within 100 N m and 100 N. `None` for τ.
    #[must_use]
    pub const fn usual(self, kind: Kind) -> Option<f64> {
        match (self, kind) {
            (Self::Q, Kind::Rotation) => Some(PI),
            (Self::Q, Kind::Translation | Kind::Quaternion)
            | (Self::Qd, Kind::Translation)
            | (Self::Weights, _) => Some(1.0),
            (Self::Tau, _) | (_, Kind::Moment(_) | Kind::Actuator { .. } | Kind::Frame) => None,
            (Self::Qd | Self::Qdd, _) => Some(10.0),
            (Self::Wrench | Self::Actions, _) => Some(100.0),
            (Self::QChange | Self::QdChange | Self::QddChange | Self::TauChange, _) => Some(1.0),
        }
    }

    /// Union of the arguments of several functions, in the order of parameters.
    #[must_use]
    pub fn together(each: impl IntoIterator<Item = Vec<Self>>) -> Vec<Self> {
        let mut all: Vec<Self> = each.into_iter().flatten().collect();
        all.sort_unstable();
        all.dedup();
        all
    }
}

/// A list for each argument, with an item for each of its entries.
#[derive(Clone, Debug, PartialEq)]
pub struct Arguments<T>([Vec<T>; Variable::ALL.len()]);

impl<T> Default for Arguments<T> {
    fn default() -> Self {
        Self::of(|_| Vec::new())
    }
}

impl<T> Arguments<T> {
    /// Calls `list` for each argument, in their order.
    pub fn of(list: impl FnMut(Variable) -> Vec<T>) -> Self {
        Self(Variable::ALL.map(list))
    }

    /// Item of an entry; `None` beyond the end of the list.
    #[must_use]
    pub fn get(&self, variable: Variable, entry: u16) -> Option<&T> {
        self[variable].get(usize::from(entry))
    }
}

impl<T> Index<Variable> for Arguments<T> {
    type Output = Vec<T>;

    fn index(&self, variable: Variable) -> &Vec<T> {
        &self.0[variable as usize]
    }
}

impl<T> IndexMut<Variable> for Arguments<T> {
    fn index_mut(&mut self, variable: Variable) -> &mut Vec<T> {
        &mut self.0[variable as usize]
    }
}
