//! Numbers whose fused multiply-add is rounded once on every target.
//!
//! In: `f32` or `f64`. Out: [`Fused`], the same number with every `a · b + c` rounded once, also inside its sines:
//! the results of a target with the instruction, on any target. If the code is compiled for a target without
//! the instruction, each is a call of a library routine.

use super::Scalar;
use super::pack::{Lane, sealed::Sealed};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number with [`mul_add`](Scalar::mul_add) rounded once on every target: bit for bit the results of its
/// primitive on a target that fuses products with sums.
///
/// ```
/// use homogen::{Fused, Scalar};
/// let (a, b) = (Fused(1.0 + f64::EPSILON), Fused(1.0 - f64::EPSILON));
/// assert_eq!(a.mul_add(b, Fused(-1.0)).0, -f64::EPSILON * f64::EPSILON);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Fused<T>(
    /// The primitive.
    pub T,
);

/// The product with a sum that the sines use.
mod fused {
    macro_rules! always {
        ($float:ident) => {
            #[inline(always)]
            pub(in super::super) fn $float(factor: $float, other: $float, term: $float) -> $float {
                factor.mul_add(other, term)
            }
        };
    }
    always!(f32);
    always!(f64);
}

// The sines call `super::fused`, here the module above, and so round once.
#[allow(
    clippy::duplicate_mod,
    reason = "the same sines over another product and sum"
)]
#[path = "trigonometry/double.rs"]
mod double;
#[allow(
    clippy::duplicate_mod,
    reason = "the same sines over another product and sum"
)]
#[path = "trigonometry/single.rs"]
mod single;

macro_rules! operator {
    ($float:ident: $($name:ident $method:ident)*) => {$(
        impl $name for Fused<$float> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

macro_rules! implement {
    ($float:ident, $sines:ident) => {
        operator!($float: Add add Sub sub Mul mul Div div);

        impl Neg for Fused<$float> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl Scalar for Fused<$float> {
            #[inline(always)]
            fn constant(value: f64) -> Self {
                Self($float::constant(value))
            }

            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                Self(fused::$float(self.0, factor.0, term.0))
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(Scalar::sqrt(self.0))
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = Scalar::sin_cos(self.0);
                (Self(sine), Self(cosine))
            }

            #[inline(always)]
            fn minus_sine(self, sine: Self) -> Self {
                Self(self.0.minus_sine(sine.0))
            }

            #[inline(always)]
            fn sign(self) -> Self {
                Self(self.0.sign())
            }

            #[inline]
            fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                let pairs = angles.map(Self::sin_cos_own);
                (pairs.map(|(sine, _)| sine), pairs.map(|(_, cosine)| cosine))
            }
        }

        impl Sealed for Fused<$float> {}

        impl Lane for Fused<$float> {
            type Bare = $float;

            #[inline(always)]
            fn of(bare: $float) -> Self {
                Self(bare)
            }

            #[inline(always)]
            fn bare(self) -> $float {
                self.0
            }

            #[inline(always)]
            fn is_moderate(self) -> bool {
                self.0.is_moderate()
            }

            #[inline(always)]
            fn sin_cos_moderate(self) -> (Self, Self) {
                let (sine, cosine) = $sines::sin_cos_moderate(self.0);
                (Self(sine), Self(cosine))
            }

            #[inline]
            fn sin_cos_own(self) -> (Self, Self) {
                let (sine, cosine) = $sines::sin_cos(self.0);
                (Self(sine), Self(cosine))
            }
        }
    };
}
implement!(f32, single);
implement!(f64, double);
