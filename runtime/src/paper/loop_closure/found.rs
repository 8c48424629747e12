//! Results of closed loops: positions and rates with their residuals, or the error.

use core::fmt::{self, Display, Formatter};

/// Coordinates at which the loops are closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position<T, const N: usize> {
    /// q [rad, m].
    pub q: [T; N],
    /// The largest component of the displacements by which the loops are open, in rad; lengths divided by
    /// the size of the robot.
    pub residual: T,
    /// Number of steps.
    pub iterations: usize,
    /// True if the passive joints are not determined to first order: a dead centre.
    pub is_singular: bool,
}

/// The error if the loops do not close: out of reach, or too far from the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotClosed {
    /// The smallest residual of all steps, as in [`Position::residual`].
    pub residual: f64,
    /// Number of steps.
    pub iterations: usize,
}

/// Rates or second rates of all joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates<T, const N: usize> {
    /// q̇ [rad/s, m/s] or q̈ [rad/s², m/s²]: the least-squares solution of least norm.
    pub values: [T; N],
    /// The rank of the columns of A that belong to the unknown joints.
    pub rank: usize,
    /// The number of unknown joints.
    pub sought: usize,
    /// The largest residual of A q̇ = 0 or A q̈ = b, lengths divided by the size of the robot: rounding, or more
    /// if the driving joints contradict the loops.
    pub residual: T,
}

impl<T, const N: usize> Rates<T, N> {
    /// True if the driving joints do not determine all others: at a dead centre, or if there are too few of them.
    #[must_use]
    pub fn is_singular(&self) -> bool {
        self.rank < self.sought
    }
}

impl Display for NotClosed {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the loops do not close: residual {:.1e} (rad, or a fraction of the robot's size) after {} steps",
            self.residual, self.iterations
        )
    }
}

impl core::error::Error for NotClosed {}
