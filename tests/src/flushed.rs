//! Single precision as many controllers have it: subnormal numbers are flushed to zero.
//!
//! In: numbers of `f32`. Out: a [`Scalar`] and [`Real`] in which every argument and every result that
//! would be subnormal is a zero of the same sign. The inside of a sine is that of `f32`; it never
//! flushes there.

use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use homogen::{Real, Scalar};

/// A number of `f32` that is never subnormal.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Flushed(f32);

impl Flushed {
    /// The number, or a zero of its sign where it is subnormal.
    #[must_use]
    pub fn new(x: f32) -> Self {
        Self(if x.is_subnormal() {
            0.0_f32.copysign(x)
        } else {
            x
        })
    }

    /// The number as `f32`.
    #[must_use]
    pub const fn get(self) -> f32 {
        self.0
    }
}

/// An operation whose result is flushed.
macro_rules! operation {
    ($operation:ident, $method:ident) => {
        impl $operation for Flushed {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self::new($operation::$method(self.0, other.0))
            }
        }
    };
}

operation!(Add, add);
operation!(Sub, sub);
operation!(Mul, mul);
operation!(Div, div);

impl Neg for Flushed {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl fmt::Display for Flushed {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, out)
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
        Self::new(self.0.sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self::new(sine), Self::new(cosine))
    }

    fn less_sine(self, sine: Self) -> Self {
        Self::new(self.0.less_sine(sine.0))
    }

    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sines, cosines) = f32::sin_cos_all(angles.map(Self::get));
        (sines.map(Self::new), cosines.map(Self::new))
    }
}

impl Real for Flushed {
    const EPSILON: Self = Self(f32::EPSILON);
    const MIN_POSITIVE: Self = Self(f32::MIN_POSITIVE);

    fn to_f64(self) -> f64 {
        f64::from(self.0)
    }

    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn atan2(self, x: Self) -> Self {
        Self::new(self.0.atan2(x.0))
    }
}

#[cfg(test)]
mod tests {
    use super::Flushed;
    use homogen::Scalar;

    #[test]
    fn what_would_be_subnormal_is_zero() {
        let least = Flushed::new(f32::MIN_POSITIVE);
        let half = Flushed::constant(0.5);
        let gap = Flushed::new(1.5 * f32::MIN_POSITIVE) - least;
        let nothing = [least * half, -least * half, gap, Flushed::constant(1e-40)];
        assert_eq!(nothing.map(Flushed::get), [0.0; 4]);
        assert!((-least * half).get().is_sign_negative());
        assert_eq!((least + least).get(), 2.0 * f32::MIN_POSITIVE);
    }
}
