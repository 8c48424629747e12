//! Double and single precision with the same bits on every platform.
//!
//! In: numbers. Out: each operation rounded once, products apart from sums, and correctly rounded sines.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::expression::{Arithmetic, Double};

/// A type of numbers that gives the same bits on every platform.
pub(super) trait Rounded: Arithmetic + Copy {
    /// The value, exactly.
    fn to_f64(&self) -> f64;
}

/// Double precision, with correctly rounded sines.
#[derive(Clone, Copy)]
pub(super) struct Plain(f64);

/// Single precision, with correctly rounded sines.
#[derive(Clone, Copy)]
pub(super) struct Single(f32);

macro_rules! implement {
    ($type:ident) => {
        impl Add for $type {
            type Output = Self;

            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }

        impl Sub for $type {
            type Output = Self;

            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }

        impl Mul for $type {
            type Output = Self;

            fn mul(self, other: Self) -> Self {
                Self(self.0 * other.0)
            }
        }

        impl Div for $type {
            type Output = Self;

            fn div(self, other: Self) -> Self {
                Self(self.0 / other.0)
            }
        }

        impl Neg for $type {
            type Output = Self;

            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl Arithmetic for $type {
            fn literal(value: f64) -> Self {
                Self(Arithmetic::literal(value))
            }

            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }

            fn sign(self) -> Self {
                Self(Arithmetic::sign(self.0))
            }

            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = Double::from(self.to_f64()).sin_cos();
                (Self::literal(sine.to_f64()), Self::literal(cosine.to_f64()))
            }
        }

        impl Rounded for $type {
            fn to_f64(&self) -> f64 {
                self.0.into()
            }
        }
    };
}

implement!(Plain);
implement!(Single);
