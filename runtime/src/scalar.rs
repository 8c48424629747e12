//! The types of numbers that everything is generic over.
//!
//! In: a type with the four operations. Out: [`Scalar`], the operations of straight-line code, and
//! [`Real`], which adds order and the inverse tangent for the few functions that must branch.
//! This module implements them for `f32`, `f64` and packs of them; other types are implemented by users.

use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};

pub mod dispatch;
#[cfg(any(feature = "std", feature = "libm"))]
mod float;
#[cfg(any(feature = "std", feature = "libm"))]
mod pack;
pub mod rounding;
pub mod trigonometry;

use dispatch::Work;
use rounding::{OfTarget, Rounding};

#[cfg(any(feature = "std", feature = "libm"))]
pub use pack::{Lane, Pack};

/// A number, with the operations of straight-line code.
///
/// The trait is open: SIMD packs, dual numbers and double-double numbers implement it as `f32` and
/// `f64` do here. It has no order, because a pack of numbers has none; functions that compare need
/// [`Real`].
///
/// `f32` and `f64` implement it with the feature `std` or, without a standard library, `libm`.
/// Without both features the types of this crate work with your own scalars.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number that `homogen` computes with",
    label = "does not implement `Scalar`",
    note = "`f32` and `f64` do with the feature `std` of `homogen`, which is on by default, or with `libm` \
            where there is no standard library"
)]
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// True if a number holds those of several states, so that functions compute limbs one after the other.
    #[doc(hidden)]
    const IS_PACK: bool = false;

    /// The number `value`, rounded to this type (and repeated in every lane of a pack).
    fn constant(value: f64) -> Self;

    /// The number `value`, with any further data of `self`: [`constant`](Self::constant) by default.
    ///
    /// Functions that are [inlined](crate::robot::Batched::INLINED) make their constants by it. A type that holds more
    /// than a value, such as the proof that the processor has its instructions, copies that from `self`.
    #[inline]
    #[must_use]
    fn like(self, value: f64) -> Self {
        let _ = self;
        Self::constant(value)
    }

    /// `self · factor + term`, fused into one rounding only where the target has the instruction.
    ///
    /// Elsewhere it is a product and a sum, never a call of a library routine.
    #[must_use]
    fn mul_add(self, factor: Self, term: Self) -> Self;

    /// `self · factor + term` with the given rounding; [`mul_add`](Self::mul_add) by default.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn mul_add_by<R: Rounding>(self, factor: Self, term: Self) -> Self {
        self.mul_add(factor, term)
    }

    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Sine and cosine of an angle \[rad\].
    ///
    /// `f32` and `f64` use the platform's functions: the standard library, or `libm`.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// φ − sin φ of an angle φ \[rad\], given its `sine`.
    ///
    /// The difference loses digits at small angles. `f32` and `f64` sum the series up to 2 rad instead; their
    /// error is at most 4 units of rounding at every angle.
    #[inline]
    #[must_use]
    fn minus_sine(self, sine: Self) -> Self {
        self - sine
    }

    /// The sign of a number: −1, 0 or 1, and exactly 0 of 0. Coulomb friction is multiplied by it.
    ///
    /// `f32` and `f64` compare. Numbers without an order have x/√(x² + 1.2e-38) by default, which is ±1 to 18 digits beyond
    /// 1e-10. Dual numbers should implement it with a derivative of zero.
    #[inline]
    #[must_use]
    fn sign(self) -> Self {
        let least = Self::constant(f64::from(f32::MIN_POSITIVE));
        self / (self * self + least).sqrt()
    }

    /// The sines and the cosines of all angles of a call \[rad\].
    ///
    /// Together they can be vectorised, as [`trigonometry`](crate::trigonometry) does for `f32` and `f64`:
    /// faster than the platform's functions, and the same on every platform.
    #[inline]
    #[must_use]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        sin_cos_each(angles)
    }

    /// The sines and cosines of all angles with the given rounding of products in sums;
    /// [`sin_cos_all`](Self::sin_cos_all) by default.
    #[doc(hidden)]
    #[inline]
    #[must_use]
    fn sin_cos_all_by<R: Rounding, const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        Self::sin_cos_all(angles)
    }

    /// Does work on numbers of this type by the instructions of the processor at hand; by those of the target by
    /// default.
    #[doc(hidden)]
    #[expect(
        clippy::inline_always,
        reason = "registers of batches are compiled for the processor that was found if all is inlined"
    )]
    #[inline(always)]
    fn dispatch<W: Work<Self>>(work: W) -> W::Output {
        work.rounded::<OfTarget>()
    }
}

/// A [`Scalar`] with an order, for logarithms, checks and normalisations.
pub trait Real: Scalar + PartialOrd + Debug + Display {
    /// The distance from 1 to the next larger number: twice the unit roundoff.
    const EPSILON: Self;

    /// The smallest positive number of full precision.
    const MIN_POSITIVE: Self;

    /// The number as `f64`, for messages.
    fn to_f64(self) -> f64;

    /// True if the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// The magnitude.
    #[must_use]
    fn abs(self) -> Self;

    /// The angle of the point (`x`, `self`) from the x axis \[rad\], in (−π, π].
    #[must_use]
    fn atan2(self, x: Self) -> Self;

    /// The larger of two numbers.
    #[inline]
    #[must_use]
    fn max(self, other: Self) -> Self {
        if self < other { other } else { self }
    }
}

/// The sines and the cosines of all angles \[rad\], each by [`Scalar::sin_cos`]: for `f32` and
/// `f64` by the platform, the standard library or `libm`.
#[inline]
#[must_use]
pub fn sin_cos_each<T: Scalar, const N: usize>(angles: [T; N]) -> ([T; N], [T; N]) {
    let pairs = angles.map(T::sin_cos);
    (pairs.map(|(sine, _)| sine), pairs.map(|(_, cosine)| cosine))
}
