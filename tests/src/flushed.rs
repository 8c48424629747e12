//! Single precision without subnormal numbers, for everything that is generic over a scalar.
//!
//! In: the operations of [`Flushed`]. Out: its [`Scalar`] and [`Real`], with the functions of `f32`
//! between two flushes. The inside of such a function is that of `f32`; it never flushes there.

use std::cmp::Ordering;
use std::fmt;

use homogen::{Real, Scalar};

use crate::tested::{Flushed, Tested};

/// The number as `f32`, which it is.
fn single(x: Flushed) -> f32 {
    f32::constant(Tested::to_f64(x))
}

impl PartialOrd for Flushed {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        single(*self).partial_cmp(&single(*other))
    }
}

impl fmt::Display for Flushed {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&single(*self), out)
    }
}

impl Scalar for Flushed {
    fn constant(value: f64) -> Self {
        Self::new(f32::constant(value))
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        Self::new(single(self).sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = single(self).sin_cos();
        (Self::new(sine), Self::new(cosine))
    }

    fn less_sine(self, sine: Self) -> Self {
        Self::new(single(self).less_sine(single(sine)))
    }

    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sines, cosines) = f32::sin_cos_all(angles.map(single));
        (sines.map(Self::new), cosines.map(Self::new))
    }
}

impl Real for Flushed {
    const EPSILON: Self = Self::new(f32::EPSILON);
    const MIN_POSITIVE: Self = Self::new(f32::MIN_POSITIVE);

    fn to_f64(self) -> f64 {
        Tested::to_f64(self)
    }

    fn is_finite(self) -> bool {
        single(self).is_finite()
    }

    fn abs(self) -> Self {
        Self::new(single(self).abs())
    }

    fn atan2(self, x: Self) -> Self {
        Self::new(single(self).atan2(single(x)))
    }
}
