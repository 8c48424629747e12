//! The numbers that everything is generic over.
//!
//! In: a type with the four operations. Out: [`Scalar`], enough for straight-line code, and
//! [`Real`], which adds order and the inverse tangent for the few functions that must branch.
//! This is the only file that knows the standard library from `libm`; it never allocates and
//! never decides anything by the value of a number.

use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::trigonometry::sin_cos_each;

/// A number as straight-line code needs it.
///
/// The trait is open: SIMD packs, dual numbers and double-double numbers implement it as `f32` and
/// `f64` do here. It asks for no order, because a pack of numbers has none; functions that must
/// compare ask for [`Real`].
///
/// `f32` and `f64` implement it with the feature `std` or, without a standard library, `libm`.
/// With neither the types of this crate still exist, for scalars of one's own.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number `value`, rounded to this type (and repeated in every lane of a pack).
    fn constant(value: f64) -> Self;

    /// `self · factor + term`, fused into one rounding only where the target has the instruction.
    ///
    /// It is never a call of a library routine: elsewhere it is a product and a sum.
    #[must_use]
    fn mul_add(self, factor: Self, term: Self) -> Self;

    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Sine and cosine of an angle \[rad\].
    ///
    /// For `f32` and `f64` the platform's: of the standard library, or of `libm`.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// φ − sin φ of an angle φ \[rad\], given its `sine`.
    ///
    /// The difference loses the digits of small angles. `f32` and `f64` sum the series instead, up
    /// to 2 rad, and are right to 4 units of rounding at every angle.
    #[inline]
    #[must_use]
    fn less_sine(self, sine: Self) -> Self {
        self - sine
    }

    /// The sines and the cosines of all angles of a call \[rad\].
    ///
    /// Evaluating them together lets an implementation vectorise them, as
    /// [`trigonometry`](crate::trigonometry) does for `f32` and `f64`: faster than the platform's
    /// and the same on every platform.
    #[inline]
    #[must_use]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        sin_cos_each(angles)
    }
}

/// A [`Scalar`] with an order: what logarithms, checks and normalisations need.
pub trait Real: Scalar + PartialOrd + Debug + Display {
    /// The distance from 1 to the next larger number: twice the unit roundoff.
    const EPSILON: Self;

    /// The smallest positive number of full precision.
    const MIN_POSITIVE: Self;

    /// The number as `f64`, for messages.
    fn to_f64(self) -> f64;

    /// Whether the number is neither infinite nor NaN.
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

/// Implements [`Scalar`] and [`Real`] for a primitive type with the functions named.
#[cfg(any(feature = "std", feature = "libm"))]
macro_rules! implement {
    ($float:ident, $sqrt:path, $sin_cos:path, $atan2:path, $constant:expr, $to_f64:expr, $sin_cos_all:path, $terms:literal) => {
        impl Scalar for $float {
            #[inline]
            fn constant(value: f64) -> Self {
                $constant(value)
            }

            #[inline]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                fused::$float(self, factor, term)
            }

            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }

            #[inline]
            fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                $sin_cos_all(angles)
            }

            #[inline]
            fn less_sine(self, sine: Self) -> Self {
                let series = arc_less_sine::<Self, $terms>(self);
                // Both are computed, and one is taken.
                if $float::abs(self) < 2.0 {
                    series
                } else {
                    self - sine
                }
            }
        }

        impl Real for $float {
            const EPSILON: Self = $float::EPSILON;
            const MIN_POSITIVE: Self = $float::MIN_POSITIVE;

            #[inline]
            fn to_f64(self) -> f64 {
                $to_f64(self)
            }

            #[inline]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }

            #[inline]
            fn abs(self) -> Self {
                $float::abs(self)
            }

            #[inline]
            fn atan2(self, x: Self) -> Self {
                $atan2(self, x)
            }
        }
    };
}

/// `factor · other + term` of the primitive types, as [`Scalar::mul_add`] promises it.
pub(crate) mod fused {
    macro_rules! implement {
        ($float:ident) => {
            // The inherent method becomes a library call where the instruction is missing, so it
            // is named only where the target is known to have it.
            #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline]
            pub(crate) fn $float(factor: $float, other: $float, term: $float) -> $float {
                $float::mul_add(factor, other, term)
            }

            #[cfg(not(all(
                feature = "std",
                any(target_feature = "fma", target_arch = "aarch64")
            )))]
            #[inline]
            pub(crate) fn $float(factor: $float, other: $float, term: $float) -> $float {
                factor * other + term
            }
        };
    }

    implement!(f32);
    implement!(f64);
}

/// φ − sin φ by the first `TERMS` terms of its series, φ³/6 (1 − φ²/20 (1 − φ²/42 (1 − …))).
#[cfg(any(feature = "std", feature = "libm"))]
#[inline]
fn arc_less_sine<T: Scalar, const TERMS: u8>(phi: T) -> T {
    let one = T::constant(1.0);
    let square = phi * phi;
    let bracket = (2..=TERMS).rev().fold(one, |bracket, k| {
        let n = 2.0 * f64::from(k);
        one - square * T::constant(1.0 / (n * (n + 1.0))) * bracket
    });
    phi * square * bracket / T::constant(6.0)
}

/// Rounds to single precision.
#[cfg(any(feature = "std", feature = "libm"))]
#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to the type is the purpose"
)]
#[inline]
fn single(value: f64) -> f32 {
    value as f32
}

#[cfg(feature = "std")]
mod backend {
    use super::{Real, Scalar, arc_less_sine, fused, single};
    use crate::trigonometry::{sin_cos_all_f32, sin_cos_all_f64};
    use core::convert::identity;

    implement!(
        f32,
        f32::sqrt,
        f32::sin_cos,
        f32::atan2,
        single,
        f64::from,
        sin_cos_all_f32,
        7
    );
    implement!(
        f64,
        f64::sqrt,
        f64::sin_cos,
        f64::atan2,
        identity,
        identity,
        sin_cos_all_f64,
        12
    );
}

#[cfg(all(feature = "libm", not(feature = "std")))]
mod backend {
    use super::{Real, Scalar, arc_less_sine, fused, single};
    use crate::trigonometry::{sin_cos_all_f32, sin_cos_all_f64};
    use core::convert::identity;

    implement!(
        f32,
        libm::sqrtf,
        libm::sincosf,
        libm::atan2f,
        single,
        f64::from,
        sin_cos_all_f32,
        7
    );
    implement!(
        f64,
        libm::sqrt,
        libm::sincos,
        libm::atan2,
        identity,
        identity,
        sin_cos_all_f64,
        12
    );
}

#[cfg(all(test, any(feature = "std", feature = "libm")))]
mod tests {
    use super::Scalar;

    #[test]
    fn all_sines_agree_with_the_platform() {
        let angles = [0.0, 1e-300, 0.5, -2.0, 1e8];
        let (sines, cosines) = f64::sin_cos_all(angles);
        for i in 0..angles.len() {
            let (sine, cosine) = Scalar::sin_cos(angles[i]);
            assert!((sines[i] - sine).abs() <= f64::EPSILON * sine.abs());
            assert!((cosines[i] - cosine).abs() <= f64::EPSILON * cosine.abs());
        }
    }

    #[test]
    fn product_and_sum_are_rounded_once_or_twice() {
        let (a, b, c) = (1.0 + f64::EPSILON, 1.0 - f64::EPSILON, -1.0);
        let once = -f64::EPSILON * f64::EPSILON;
        let result = Scalar::mul_add(a, b, c).to_bits();
        assert!([0.0_f64, once].map(f64::to_bits).contains(&result));
    }

    #[test]
    fn constants_are_rounded_to_the_type() {
        assert_eq!(<f32 as Scalar>::constant(0.1).to_bits(), 0.1_f32.to_bits());
        assert_eq!(<f64 as Scalar>::constant(0.1).to_bits(), 0.1_f64.to_bits());
    }
}
