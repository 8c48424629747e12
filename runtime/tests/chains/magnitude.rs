//! Magnitudes: the same sums and products on absolute values.
//!
//! What comes out of a function of magnitudes is S, the size of what was added up on the way: the
//! scale against which rounding is fair even where the result cancels.

use homogen::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// |x|.
#[derive(Clone, Copy, Debug)]
pub struct Magnitude(pub f64);

impl Add for Magnitude {
    type Output = Self;

    fn add(self, y: Self) -> Self {
        Self(self.0 + y.0)
    }
}

impl Sub for Magnitude {
    type Output = Self;

    fn sub(self, y: Self) -> Self {
        self + -y
    }
}

impl Neg for Magnitude {
    type Output = Self;

    fn neg(self) -> Self {
        self
    }
}

impl Mul for Magnitude {
    type Output = Self;

    fn mul(self, y: Self) -> Self {
        Self(self.0 * y.0)
    }
}

impl Div for Magnitude {
    type Output = Self;

    fn div(self, y: Self) -> Self {
        Self(self.0 / y.0)
    }
}

impl Scalar for Magnitude {
    fn constant(value: f64) -> Self {
        Self(value.abs())
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.0.sin_cos();
        (Self(s.abs()), Self(c.abs()))
    }
}
