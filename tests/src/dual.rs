//! Dual numbers: generated code that runs on them differentiates itself, to rounding.
//!
//! In: a value and its slope in one direction. Out: a [`Scalar`] whose operations follow the rules
//! of differentiation.

use std::ops::{Add, Div, Mul, Neg, Sub};

use homogen::Scalar;

/// a + b ε with ε² = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Dual {
    /// A number with its derivative.
    #[must_use]
    pub const fn new(value: f64, slope: f64) -> Self {
        Self { value, slope }
    }

    /// Numbers with their derivatives.
    #[must_use]
    pub fn pairs<const N: usize>(values: &[f64; N], slopes: &[f64; N]) -> [Self; N] {
        std::array::from_fn(|i| Self::new(values[i], slopes[i]))
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.slope + other.slope)
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.slope - other.slope)
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let slope = self.slope * other.value + self.value * other.slope;
        Self::new(self.value * other.value, slope)
    }
}

impl Div for Dual {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::new(value, (self.slope - value * other.slope) / other.value)
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope)
    }
}

impl Scalar for Dual {
    fn constant(value: f64) -> Self {
        Self::new(value, 0.0)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.slope / (2.0 * root))
    }

    fn sign(self) -> Self {
        Self::new(Scalar::sign(self.value), 0.0)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (
            Self::new(sine, self.slope * cosine),
            Self::new(cosine, -self.slope * sine),
        )
    }
}
