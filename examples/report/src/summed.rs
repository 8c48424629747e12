//! A number of 106 bits that knows how large its terms are.
//!
//! In: the operations of an expression. Out: beside each value the sum of the magnitudes that it was
//! summed from, which is what rounding errors are in proportion to.

use std::ops::{Add, Div, Mul, Neg, Sub};

use homogen_codegen::expression::{Arithmetic, Double};

/// A value, and the same operations on absolute values.
#[derive(Clone, Copy)]
pub struct Summed {
    /// The value.
    pub value: Double,
    /// What it was summed from, if nothing cancelled.
    pub magnitude: f64,
}

impl Summed {
    fn alone(value: Double) -> Self {
        Self {
            value,
            magnitude: value.to_f64().abs(),
        }
    }
}

impl Arithmetic for Summed {
    fn literal(value: f64) -> Self {
        Self::alone(Double::from(value))
    }

    fn sqrt(self) -> Self {
        Self::alone(self.value.sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (Self::alone(sine), Self::alone(cosine))
    }
}

impl Add for Summed {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            magnitude: self.magnitude + other.magnitude,
        }
    }
}

impl Sub for Summed {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            magnitude: self.magnitude + other.magnitude,
        }
    }
}

impl Mul for Summed {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            magnitude: self.magnitude * other.magnitude,
        }
    }
}

impl Div for Summed {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self::alone(self.value / other.value)
    }
}

impl Neg for Summed {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}
