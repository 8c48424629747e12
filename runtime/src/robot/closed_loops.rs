//! A robot with closed loops as data.
//!
//! In: a [`Chain`] and the residuals of its loops. Out: a constant for the recursions at run time
//! ([`crate::generic`]), which generated code has beside its straight-line functions.

use super::chain::{Chain, Frame};

/// A robot with closed loops: a tree of bodies and joints, and `C` residuals that are zero where the loops are
/// closed.
///
/// It implements every function of loops, so that [`loop_closure`](mod@crate::loop_closure) projects its
/// states like those of generated robots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedLoopRobot<
    const N: usize,
    const F: usize,
    const C: usize,
    const Q: usize = N,
    const B: usize = N,
> {
    /// The tree, with the loops cut open.
    pub chain: Chain<N, F, Q, B>,
    /// The residuals of its loops.
    pub residuals: [Residual; C],
    /// True for each velocity that has an actuator; loops move the others.
    pub actuated: [bool; N],
}

/// One equation of a loop: a number that is zero where the loop is closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// Its name.
    pub name: &'static str,
    /// The frames A and B of its loop.
    pub frames: [Frame; 2],
    /// The expression of the pose of B in A.
    pub row: ResidualKind,
}

/// The expression of a residual in the pose M of frame B in frame A.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ResidualKind {
    /// The coordinate of the origin of B along an axis of A \[m\].
    Along(usize),
    /// The scalar product of an axis of A and an axis of B: zero if they are perpendicular.
    Product(usize, usize),
    /// The scalar product of the z axes of A and B, minus this cosine.
    Inclined(f64),
    /// (d² − l²)/2l with the distance d of the origins and this length l \[m\].
    Distance(f64),
}

impl<const N: usize, const F: usize, const C: usize, const Q: usize, const B: usize>
    ClosedLoopRobot<N, F, C, Q, B>
{
    /// A robot with closed loops. Nothing is checked, so that it can be a constant.
    #[inline]
    #[must_use]
    pub const fn new(
        chain: Chain<N, F, Q, B>,
        residuals: [Residual; C],
        actuated: [bool; N],
    ) -> Self {
        Self {
            chain,
            residuals,
            actuated,
        }
    }
}

impl Residual {
    /// A residual of two frames.
    #[inline]
    #[must_use]
    pub const fn new(name: &'static str, frames: [Frame; 2], row: ResidualKind) -> Self {
        Self { name, frames, row }
    }
}

impl ResidualKind {
    /// True if the residual is a length \[m\], false if it is a cosine.
    #[must_use]
    pub const fn is_length(self) -> bool {
        matches!(self, Self::Along(_) | Self::Distance(_))
    }
}
