//! What is found about closed loops: positions and rates, with how good they are, or why there are
//! none.

use core::fmt::{self, Display, Formatter};

/// Coordinates at which the loops are closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Position<T, const N: usize> {
    /// q [rad, m].
    pub q: [T; N],
    /// How far the loops are from closed: the largest component of the screws that are missing, in
    /// rad, or in parts of the size of the mechanism.
    pub residual: T,
    /// The steps that led to `q`.
    pub iterations: usize,
    /// Whether the joints that are not driven cannot be found to first order here: a dead centre.
    pub is_singular: bool,
}

/// The loops do not close: out of reach, or too far from the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotClosed {
    /// The smallest distance from closed that was met, as in [`Position::residual`].
    pub residual: f64,
    /// The steps taken.
    pub iterations: usize,
}

/// Rates or second rates of all joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates<T, const N: usize> {
    /// q̇ [rad/s, m/s] or q̈ [rad/s², m/s²]; where they are not determined, those of least norm
    /// among the ones that come closest.
    pub values: [T; N],
    /// The rank of the columns of A that belong to the joints sought.
    pub rank: usize,
    /// The number of joints sought.
    pub sought: usize,
    /// The largest row of what remains of A q̇ = 0 or A q̈ = b, lengths in parts of the size of the
    /// mechanism: rounding, or more where the driving joints contradict the loops.
    pub residual: T,
}

impl<T, const N: usize> Rates<T, N> {
    /// Whether the driving joints leave some joint undetermined: a dead centre, or too few of them.
    #[must_use]
    pub fn is_singular(&self) -> bool {
        self.rank < self.sought
    }
}

impl Display for NotClosed {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the loops do not close: {:.1e} rad, or parts of the size of the mechanism, remain after {} steps",
            self.residual, self.iterations
        )
    }
}

impl core::error::Error for NotClosed {}
