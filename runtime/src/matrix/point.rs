//! Points: four homogeneous coordinates whose last one, w, is 1 or 0.
//!
//! In: three coordinates in some frame. Out: [`Point`] (w = 1) and [`Direction`] (w = 0, a point at
//! infinity, § 2.2), two types, so that w need not be stored.

use super::vector;
use crate::scalar::Scalar;
use core::ops::{Add, Neg, Sub};

/// A point P = (x, y, z, 1)ᵗ \[m\] in some frame (§ 2.2).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Point<T>(
    /// x, y, z \[m\].
    pub [T; 3],
);

/// A point at infinity (x, y, z, 0)ᵗ in some frame (§ 2.2): a free vector, such as an axis, the
/// difference of two points, a velocity Ṗ or an acceleration P̈.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Direction<T>(
    /// x, y, z in the unit of the vector.
    pub [T; 3],
);

impl<T: Scalar> Point<T> {
    /// (x, y, z, 1)ᵗ.
    #[inline]
    #[must_use]
    pub fn to_homogeneous(&self) -> [T; 4] {
        let [x, y, z] = self.0;
        [x, y, z, T::constant(1.0)]
    }

    /// The origin of the frame.
    #[inline]
    #[must_use]
    pub fn origin() -> Self {
        Self([T::constant(0.0); 3])
    }
}

impl<T: Scalar> Direction<T> {
    /// (x, y, z, 0)ᵗ.
    #[inline]
    #[must_use]
    pub fn to_homogeneous(&self) -> [T; 4] {
        let [x, y, z] = self.0;
        [x, y, z, T::constant(0.0)]
    }

    /// The vector multiplied by `factor`.
    #[inline]
    #[must_use]
    pub fn scaled(&self, factor: T) -> Self {
        Self(vector::scale(factor, self.0))
    }
}

impl<T: Scalar> Sub for Point<T> {
    type Output = Direction<T>;

    #[inline]
    fn sub(self, other: Self) -> Direction<T> {
        Direction(vector::sub(self.0, other.0))
    }
}

impl<T: Scalar> Add<Direction<T>> for Point<T> {
    type Output = Self;

    #[inline]
    fn add(self, step: Direction<T>) -> Self {
        Self(vector::add(self.0, step.0))
    }
}

impl<T: Scalar> Sub<Direction<T>> for Point<T> {
    type Output = Self;

    #[inline]
    fn sub(self, step: Direction<T>) -> Self {
        Self(vector::sub(self.0, step.0))
    }
}

impl<T: Scalar> Add for Direction<T> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self(vector::add(self.0, other.0))
    }
}

impl<T: Scalar> Sub for Direction<T> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(vector::sub(self.0, other.0))
    }
}

impl<T: Scalar> Neg for Direction<T> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(vector::negate(self.0))
    }
}
