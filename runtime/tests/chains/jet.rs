//! A number with its first and second derivative with respect to time: a scalar that differentiates.
//!
//! The positions of a chain, computed with jets, carry velocities and accelerations that owe nothing
//! to W, H or their composition.

use homogen::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// x, ẋ, ẍ.
#[derive(Clone, Copy, Debug)]
pub struct Jet(pub f64, pub f64, pub f64);

impl Add for Jet {
    type Output = Self;

    fn add(self, y: Self) -> Self {
        Self(self.0 + y.0, self.1 + y.1, self.2 + y.2)
    }
}

impl Neg for Jet {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0, -self.1, -self.2)
    }
}

impl Sub for Jet {
    type Output = Self;

    fn sub(self, y: Self) -> Self {
        self + -y
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, y: Self) -> Self {
        Self(
            self.0 * y.0,
            self.1 * y.0 + self.0 * y.1,
            self.2 * y.0 + 2.0 * self.1 * y.1 + self.0 * y.2,
        )
    }
}

impl Div for Jet {
    type Output = Self;

    fn div(self, y: Self) -> Self {
        // From self = ratio · y.
        let x = self.0 / y.0;
        let x_d = (self.1 - x * y.1) / y.0;
        let x_dd = (self.2 - 2.0 * x_d * y.1 - x * y.2) / y.0;
        Self(x, x_d, x_dd)
    }
}

impl Scalar for Jet {
    fn constant(value: f64) -> Self {
        Self(value, 0.0, 0.0)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        let root_d = self.1 / (2.0 * root);
        Self(
            root,
            root_d,
            (self.2 - 2.0 * root_d * root_d) / (2.0 * root),
        )
    }

    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.0.sin_cos();
        let square = self.1 * self.1;
        (
            Self(s, c * self.1, c * self.2 - s * square),
            Self(c, -s * self.1, -s * self.2 - c * square),
        )
    }
}
