//! A robot with closed loops as data.
//!
//! In: a [`Chain`] and what holds its frames together. Out: a constant that the recursions at run time
//! read ([`crate::generic`]) and that generated code carries beside its straight-line functions. It
//! computes nothing itself.

use super::chain::{Chain, Frame};

/// A tree of bodies and joints, with `C` residuals that are zero where its loops are closed.
///
/// It has every function of loops, so that its states can be projected as those of generated robots are
/// ([`loop_closure`](mod@crate::loop_closure)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mechanism<
    const N: usize,
    const F: usize,
    const C: usize,
    const Q: usize = N,
    const B: usize = N,
> {
    /// What hangs on the base, loops open.
    pub chain: Chain<N, F, Q, B>,
    /// What its loops close.
    pub residuals: [Residual; C],
    /// Which velocities are driven, where loops move the others.
    pub driven: [bool; N],
}

/// An equation of a closure: a number that is zero where the loop is closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// Its name.
    pub name: &'static str,
    /// The frames A and B that its loop holds together.
    pub frames: [Frame; 2],
    /// What it is of the pose of B as A sees it.
    pub row: Row,
}

/// What a residual is of the pose M of frame B as frame A sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Row {
    /// How far the origin of B is from that of A along an axis of A \[m\].
    Along(usize),
    /// An axis of A times an axis of B, which are perpendicular.
    Product(usize, usize),
    /// z of A times z of B, less this.
    Inclined(f64),
    /// (d² − l²)/2l of the distance d of the origins and this length l \[m\].
    Distance(f64),
}

impl<const N: usize, const F: usize, const C: usize, const Q: usize, const B: usize>
    Mechanism<N, F, C, Q, B>
{
    /// A robot with loops; nothing is checked, so that it can be a constant.
    #[inline]
    #[must_use]
    pub const fn new(
        chain: Chain<N, F, Q, B>,
        residuals: [Residual; C],
        driven: [bool; N],
    ) -> Self {
        Self {
            chain,
            residuals,
            driven,
        }
    }
}

impl Residual {
    /// A residual of two frames.
    #[inline]
    #[must_use]
    pub const fn new(name: &'static str, frames: [Frame; 2], row: Row) -> Self {
        Self { name, frames, row }
    }
}

impl Row {
    /// Whether it measures a length, and not the cosine of an angle.
    #[must_use]
    pub const fn is_length(self) -> bool {
        matches!(self, Self::Along(_) | Self::Distance(_))
    }
}
