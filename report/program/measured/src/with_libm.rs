//! Double precision with the sines of `libm`, the crate for targets without a standard library.
//!
//! In: the operations of `f64`. Out: the same, except for sines and cosines. Everything is inlined.

use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use homogen::{Real, Scalar};

use crate::entries::Entries;

/// A number of `f64`.
#[allow(
    dead_code,
    reason = "the generated robots compute with it, where there are any"
)]
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Libm(f64);

macro_rules! operation {
    ($Operation:ident, $operation:ident) => {
        impl $Operation for Libm {
            type Output = Self;

            #[inline]
            fn $operation(self, other: Self) -> Self {
                Self($Operation::$operation(self.0, other.0))
            }
        }
    };
}

operation!(Add, add);
operation!(Sub, sub);
operation!(Mul, mul);
operation!(Div, div);

impl Neg for Libm {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Scalar for Libm {
    #[inline]
    fn constant(value: f64) -> Self {
        Self(value)
    }

    #[inline]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(Scalar::mul_add(self.0, factor.0, term.0))
    }

    #[inline]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = libm::sincos(self.0);
        (Self(sine), Self(cosine))
    }
}

impl Real for Libm {
    const EPSILON: Self = Self(f64::EPSILON);
    const MIN_POSITIVE: Self = Self(f64::MIN_POSITIVE);

    fn to_f64(self) -> f64 {
        self.0
    }

    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn atan2(self, x: Self) -> Self {
        Self(self.0.atan2(x.0))
    }
}

impl fmt::Display for Libm {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, out)
    }
}

impl Entries for Libm {
    fn push(&self, numbers: &mut Vec<f64>) {
        numbers.push(self.0);
    }
}
