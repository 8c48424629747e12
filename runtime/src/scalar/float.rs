//! `f32` and `f64` as scalars.
//!
//! [`Scalar`] and [`Real`] for both, with square roots, single sines and inverse tangents of the standard
//! library or of `libm`; no other file calls these. [`super::trigonometry`] has the sines of a whole call.
use super::dispatch::{Work, at_hand};
use super::rounding::{OfTarget, Rounding};
use super::trigonometry::{inlined_f32, inlined_f64, sin_cos_all_f32, sin_cos_all_f64};
use super::{Real, Scalar};
use core::convert::identity;

/// The function of the standard library, or of `libm` where there is none.
#[cfg(feature = "std")]
macro_rules! platform {
    ($std:path, $libm:path) => {
        $std
    };
}
#[cfg(not(feature = "std"))]
macro_rules! platform {
    ($std:path, $libm:path) => {
        $libm
    };
}

/// Implements [`Scalar`] and [`Real`] for a primitive type with the given functions.
macro_rules! implement {
    ($float:ident, $sqrt:expr, $sin_cos:expr, $atan2:expr, $constant:expr, $to_f64:expr, $sin_cos_all:path, $inlined:ident, $terms:literal) => {
        impl Scalar for $float {
            #[inline]
            fn constant(value: f64) -> Self {
                $constant(value)
            }

            #[inline]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                OfTarget::$float(self, factor, term)
            }

            #[inline(always)]
            fn mul_add_by<R: Rounding>(self, factor: Self, term: Self) -> Self {
                R::$float(self, factor, term)
            }

            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline]
            fn sign(self) -> Self {
                Self::from(i8::from(self > 0.0) - i8::from(self < 0.0))
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }

            #[cfg_attr(target_feature = "avx512f", inline(always))]
            #[cfg_attr(not(target_feature = "avx512f"), inline)]
            fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                $sin_cos_all(angles)
            }

            #[inline(always)]
            fn sin_cos_all_by<R: Rounding, const N: usize>(
                angles: [Self; N],
            ) -> ([Self; N], [Self; N]) {
                if R::FUSES && OfTarget::FUSES {
                    $sin_cos_all(angles)
                } else {
                    $inlined::<R, N>(angles)
                }
            }

            #[inline(always)]
            fn dispatch<W: Work<Self>>(work: W) -> W::Output {
                at_hand(work)
            }

            #[inline]
            fn minus_sine(self, sine: Self) -> Self {
                let series = arc_less_sine::<Self, $terms>(self);
                // Both are computed and one is selected, without a branch.
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

/// φ − sin φ by the first `TERMS` terms of its series, φ³/6 (1 − φ²/20 (1 − φ²/42 (1 − …))).
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
#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to the type is the purpose"
)]
#[inline]
fn single(value: f64) -> f32 {
    value as f32
}

implement!(
    f32,
    platform!(f32::sqrt, libm::sqrtf),
    platform!(f32::sin_cos, libm::sincosf),
    platform!(f32::atan2, libm::atan2f),
    single,
    f64::from,
    sin_cos_all_f32,
    inlined_f32,
    7
);
implement!(
    f64,
    platform!(f64::sqrt, libm::sqrt),
    platform!(f64::sin_cos, libm::sincos),
    platform!(f64::atan2, libm::atan2),
    identity,
    identity,
    sin_cos_all_f64,
    inlined_f64,
    12
);

#[cfg(test)]
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
