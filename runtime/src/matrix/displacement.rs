//! Q, the rototranslation matrix.
//!
//! In: a rotation and a translation, or two poses of one body. Out: the displacement of a body, in one
//! frame. [`Displacement::log`] gives its axis, angle and pitch.

use super::point::{Direction, Point};
use super::pose::Pose;
use crate::scalar::Scalar;
use core::ops::Mul;

/// The rototranslation Q₍ₖ₎ = (R, t; 0, 1) that maps the positions of the points of a body before a
/// motion to those after it, both in frame (k) (§ 2.3, (2)).
///
/// It has the blocks of a [`Pose`] but another change of frame, M Q M⁻¹, hence a type of its own. t is the
/// displacement \[m\] of the pole, the point of the body that was at the origin of (k).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Displacement<T> {
    blocks: Pose<T>,
}

impl<T> Displacement<T> {
    /// The displacement with the rows `rotation` of R and t = `translation` \[m\]; nothing is checked.
    #[inline]
    #[must_use]
    pub const fn new(rotation: [[T; 3]; 3], translation: [T; 3]) -> Self {
        Self {
            blocks: Pose::new(rotation, translation),
        }
    }

    /// R, as rows.
    #[inline]
    #[must_use]
    pub const fn rotation(&self) -> &[[T; 3]; 3] {
        self.blocks.rotation()
    }
}

impl<T: Copy> Displacement<T> {
    /// t, the displacement of the pole \[m\].
    #[inline]
    #[must_use]
    pub const fn translation(&self) -> [T; 3] {
        self.blocks.translation()
    }

    /// Q₍₁₎ = Q₍₂₎ = M₁,₂: the displacement of a frame from (1) to (2), in either of them (after (5)).
    #[inline]
    #[must_use]
    pub const fn from_relative_pose(m_1_2: Pose<T>) -> Self {
        Self { blocks: m_1_2 }
    }

    /// M₁,₂ = Q₍₁₎, for a displacement given in frame (1) or (2) (after (5)).
    #[inline]
    #[must_use]
    pub const fn to_relative_pose(&self) -> Pose<T> {
        self.blocks
    }
}

impl<T: Scalar> Displacement<T> {
    /// No displacement.
    #[inline]
    #[must_use]
    pub fn identity() -> Self {
        Self {
            blocks: Pose::identity(),
        }
    }

    /// Q₍₀₎ = M₀,₂ M₁,₀, which takes a frame from its pose `m_0_1` to `m_0_2` (4).
    #[inline]
    #[must_use]
    pub fn between(m_0_1: &Pose<T>, m_0_2: &Pose<T>) -> Self {
        Self {
            blocks: *m_0_2 * m_0_1.inverse(),
        }
    }

    /// The inverse displacement.
    #[inline]
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self {
            blocks: self.blocks.inverse(),
        }
    }

    /// The 4×4 matrix (R, t; 0 0 0 1), as rows.
    #[inline]
    #[must_use]
    pub fn to_matrix(&self) -> [[T; 4]; 4] {
        self.blocks.to_matrix()
    }
}

impl<T: Scalar> Mul for Displacement<T> {
    type Output = Self;

    /// `self` after `first`, both in one frame.
    #[inline]
    fn mul(self, first: Self) -> Self {
        Self {
            blocks: self.blocks * first.blocks,
        }
    }
}

impl<T: Scalar> Mul<Pose<T>> for Displacement<T> {
    type Output = Pose<T>;

    /// M₀,₂ = Q M₀,₁ (3).
    #[inline]
    fn mul(self, m_0_1: Pose<T>) -> Pose<T> {
        self.blocks * m_0_1
    }
}

impl<T: Scalar> Mul<Point<T>> for Displacement<T> {
    type Output = Point<T>;

    /// P₂ = Q P₁ (2).
    #[inline]
    fn mul(self, point: Point<T>) -> Point<T> {
        self.blocks * point
    }
}

impl<T: Scalar> Mul<Direction<T>> for Displacement<T> {
    type Output = Direction<T>;

    /// A direction is rotated and not translated.
    #[inline]
    fn mul(self, direction: Direction<T>) -> Direction<T> {
        self.blocks * direction
    }
}
