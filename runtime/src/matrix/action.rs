//! Φ, the wrench: the paper's action matrix.
//!
//! In: a torque and a force, or a force at a point. Out: their 4×4 matrix, which adds to other wrenches
//! only. [`crate::Inertia::action`] makes it from H and J.

use super::form::dynamic_matrix;
use super::vector::{add, cross, negate, sub};
use crate::scalar::Scalar;
use core::ops::{Add, Neg, Sub};

/// A wrench, the paper's action matrix Φᵢ₍ₖ₎ = (c̲, f; −fᵗ, 0) (§ 4.1, (14)).
///
/// c is the torque about the origin of frame (k) [N m], f the resultant of the forces \[N\].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Action<T> {
    c: [T; 3],
    f: [T; 3],
}

impl<T> Action<T> {
    /// (c̲, f; −fᵗ, 0), in N m and N.
    ///
    /// SPACELIB: `actom`.
    #[inline]
    #[must_use]
    pub const fn new(c: [T; 3], f: [T; 3]) -> Self {
        Self { c, f }
    }
}

impl<T: Copy> Action<T> {
    /// c, the torque about the origin of the frame [N m].
    #[inline]
    #[must_use]
    pub const fn c(&self) -> [T; 3] {
        self.c
    }

    /// f, the resultant of the forces \[N\].
    #[inline]
    #[must_use]
    pub const fn f(&self) -> [T; 3] {
        self.f
    }
}

impl<T: Scalar> Action<T> {
    /// No torque and no force.
    #[inline]
    #[must_use]
    pub fn zero() -> Self {
        Self::new([T::constant(0.0); 3], [T::constant(0.0); 3])
    }

    /// f Pᵗ − P fᵗ, the wrench of a `force` \[N\] at `position` \[m\]: the integrand of Φ (§ 4.1).
    #[inline]
    #[must_use]
    pub fn of_force(force: [T; 3], position: [T; 3]) -> Self {
        Self::new(cross(position, force), force)
    }

    /// The 4×4 matrix (c̲, f; −fᵗ, 0), as rows.
    #[inline]
    #[must_use]
    pub fn to_matrix(&self) -> [[T; 4]; 4] {
        dynamic_matrix(self.c, self.f)
    }
}

impl<T: Scalar> Add for Action<T> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(add(self.c, other.c), add(self.f, other.f))
    }
}

impl<T: Scalar> Sub for Action<T> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(sub(self.c, other.c), sub(self.f, other.f))
    }
}

impl<T: Scalar> Neg for Action<T> {
    type Output = Self;

    /// The reaction.
    #[inline]
    fn neg(self) -> Self {
        Self::new(negate(self.c), negate(self.f))
    }
}
