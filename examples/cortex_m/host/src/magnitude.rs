//! A number that knows how large it could be if nothing cancelled.
//!
//! In: the operations of a generated function. Out: beside each value the sum of the magnitudes of
//! what was added up to it: the measure of its rounding error. It never rounds less than f64 does.

use std::ops::{Add, Div, Mul, Neg, Sub};

use homogen::Scalar;

/// A value, and its size without cancellation.
#[derive(Clone, Copy, Debug)]
pub struct Magnitude {
    value: f64,
    /// The sum of magnitudes.
    pub size: f64,
}

impl Magnitude {
    /// A number that is given.
    pub fn given(value: f64) -> Self {
        let size = value.abs();
        Self { value, size }
    }
}

impl Add for Magnitude {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            size: self.size + other.size,
        }
    }
}

impl Sub for Magnitude {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Magnitude {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            size: self.size * other.size,
        }
    }
}

impl Div for Magnitude {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self {
            value: self.value / other.value,
            size: self.size / other.value.abs() * (other.size / other.value.abs()),
        }
    }
}

impl Neg for Magnitude {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl Scalar for Magnitude {
    fn constant(value: f64) -> Self {
        Self::given(value)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        let size = self.size / value;
        Self { value, size }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (Self::given(sine), Self::given(cosine))
    }
}
