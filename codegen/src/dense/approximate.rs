//! Numbers of 106 bits with a bound of the error that the rounding of literals may cause.
//!
//! In: literals, each within 2⁻⁵³ of the exact number, and inputs, which are exact. Out: the results of operations, and
//! their distance from the exact results at most. The rounding of 106 bits itself is not included.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::expression::{Arithmetic, Double};

/// A number, and a bound of its distance from the exact one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Approximate {
    pub(crate) value: Double,
    pub(crate) error: f64,
}

/// Relative error of one rounding to `f64`.
pub(crate) const ROUNDOFF: f64 = f64::EPSILON / 2.0;

impl Approximate {
    /// An exact number.
    pub(crate) fn exact(value: impl Into<Double>) -> Self {
        Self {
            value: value.into(),
            error: 0.0,
        }
    }

    /// A number of a description, which becomes a literal.
    pub(crate) fn written(value: Double) -> Self {
        Self {
            value,
            error: ROUNDOFF * value.to_f64().abs(),
        }
    }

    /// A computed number that is taken as exact.
    pub(crate) const fn as_found(self) -> Self {
        Self { error: 0.0, ..self }
    }

    pub(crate) const fn to_f64(self) -> f64 {
        self.value.to_f64()
    }

    pub(crate) fn size(self) -> f64 {
        self.value.to_f64().abs()
    }

    /// The rounding of 106 bits and underflow: 2⁻⁸³ of the terms, as far as literals are among them, plus a multiple
    /// of the radius of the enclosure.
    pub(crate) fn noise(self) -> f64 {
        let radius = self.value.radius();
        let radius = if radius.is_finite() { radius } else { 0.0 };
        1e-9 * self.error + 16.0 * radius
    }

    /// True for a zero that is exact; most entries of dense matrices are.
    fn is_nothing(self) -> bool {
        self.error == 0.0 && self.value.is_exactly_zero()
    }

    fn sum(value: Double, self_error: f64, other_error: f64) -> Self {
        let error = self_error + other_error;
        Self { value, error }
    }
}

impl Add for Approximate {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is_nothing() {
            return other;
        }
        if other.is_nothing() {
            return self;
        }
        Self::sum(self.value + other.value, self.error, other.error)
    }
}

impl Sub for Approximate {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        if other.is_nothing() {
            return self;
        }
        Self::sum(self.value - other.value, self.error, other.error)
    }
}

impl Neg for Approximate {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl Mul for Approximate {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        // Unknown numbers have unknown products.
        let is_nothing = |zero: Self, of: Self| zero.is_nothing() && of.value.is_known();
        if is_nothing(self, other) || is_nothing(other, self) {
            return Self::exact(0.0);
        }
        let error = self.size() * other.error + self.error * (other.size() + other.error);
        Self {
            value: self.value * other.value,
            error,
        }
    }
}

impl Div for Approximate {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let least = other.size() - other.error;
        let error = if least > 0.0 {
            (self.error + value.to_f64().abs() * other.error) / least
        } else {
            f64::INFINITY
        };
        Self { value, error }
    }
}

impl Arithmetic for Approximate {
    fn literal(value: f64) -> Self {
        Self::written(Double::from(value))
    }

    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let error = if self.error > 0.0 {
            self.error / value.to_f64()
        } else {
            0.0
        };
        Self { value, error }
    }

    fn sign(self) -> Self {
        Self {
            value: self.value.sign(),
            error: 0.0,
        }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        let with_error = |value| Self { value, ..self };
        (with_error(sine), with_error(cosine))
    }
}
