//! [`Scalar`] and [`Real`] for the tested types.
//!
//! In: the operations of [`F32`], [`F64`], [`Flushed`], [`Fused32`] and [`Fused64`]. Out: the traits, whose functions
//! are those of the number inside. They neither flush nor fuse within a function, except for the sines and cosines of
//! all joints, which are those of the type.

use std::cmp::Ordering;
use std::fmt;

use homogen::{Real, Scalar};
use homogen_codegen::expression::Arithmetic;

use crate::tested::{F32, F64, Flushed, Fused32, Fused64, Tested};

macro_rules! implement {
    ($type:ident, $float:ident, $new:expr) => {
        impl PartialOrd for $type {
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                self.0.partial_cmp(&other.0)
            }
        }

        impl fmt::Display for $type {
            fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(&self.0, out)
            }
        }

        impl Scalar for $type {
            fn constant(value: f64) -> Self {
                Self::literal(value)
            }

            fn mul_add(self, factor: Self, term: Self) -> Self {
                Arithmetic::mul_add(self, factor, term)
            }

            fn sqrt(self) -> Self {
                Arithmetic::sqrt(self)
            }

            fn sign(self) -> Self {
                $new(Scalar::sign(self.0))
            }

            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = self.0.sin_cos();
                ($new(sine), $new(cosine))
            }

            fn minus_sine(self, sine: Self) -> Self {
                $new(self.0.minus_sine(sine.0))
            }

            fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                let pairs = angles.map(Arithmetic::sin_cos);
                (pairs.map(|(sine, _)| sine), pairs.map(|(_, cosine)| cosine))
            }
        }

        impl Real for $type {
            const EPSILON: Self = $new($float::EPSILON);
            const MIN_POSITIVE: Self = $new($float::MIN_POSITIVE);

            fn to_f64(self) -> f64 {
                Tested::to_f64(self)
            }

            fn is_finite(self) -> bool {
                self.0.is_finite()
            }

            fn abs(self) -> Self {
                $new(self.0.abs())
            }

            fn atan2(self, x: Self) -> Self {
                $new(self.0.atan2(x.0))
            }
        }
    };
}

implement!(F32, f32, Self);
implement!(F64, f64, Self);
implement!(Flushed, f32, Self::new);
implement!(Fused32, f32, Self);
implement!(Fused64, f64, Self);
