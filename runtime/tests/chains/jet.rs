//! Automatic differentiation: a number with its first and second derivative with respect to time.
//!
//! In: numbers and their derivatives. Out: the derivatives of results, to rounding. Positions of a body then
//! have velocities and accelerations that are independent of W, H and their composition.

use homogen::{Real, Scalar};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// x, ẋ, ẍ.
#[derive(Clone, Copy, Debug)]
pub struct Jet<T = f64>(pub T, pub T, pub T);

impl<T: Real> Jet<T> {
    /// A constant.
    pub fn still(x: T) -> Self {
        let zero = T::constant(0.0);
        Self(x, zero, zero)
    }

    /// The variable t at x, with derivative 1.
    pub fn moving(x: T) -> Self {
        Self(x, T::constant(1.0), T::constant(0.0))
    }
}

fn twice<T: Real>(x: T) -> T {
    x + x
}

impl<T: Real> Add for Jet<T> {
    type Output = Self;

    fn add(self, y: Self) -> Self {
        Self(self.0 + y.0, self.1 + y.1, self.2 + y.2)
    }
}

impl<T: Real> Neg for Jet<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0, -self.1, -self.2)
    }
}

impl<T: Real> Sub for Jet<T> {
    type Output = Self;

    fn sub(self, y: Self) -> Self {
        self + -y
    }
}

impl<T: Real> Mul for Jet<T> {
    type Output = Self;

    fn mul(self, y: Self) -> Self {
        Self(
            self.0 * y.0,
            self.1 * y.0 + self.0 * y.1,
            self.2 * y.0 + twice(self.1 * y.1) + self.0 * y.2,
        )
    }
}

impl<T: Real> Div for Jet<T> {
    type Output = Self;

    fn div(self, y: Self) -> Self {
        // From self = ratio · y.
        let x = self.0 / y.0;
        let x_d = (self.1 - x * y.1) / y.0;
        let x_dd = (self.2 - twice(x_d * y.1) - x * y.2) / y.0;
        Self(x, x_d, x_dd)
    }
}

impl<T: Real> Scalar for Jet<T> {
    fn constant(value: f64) -> Self {
        Self::still(T::constant(value))
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        let root_d = self.1 / twice(root);
        Self(
            root,
            root_d,
            (self.2 - twice(root_d * root_d)) / twice(root),
        )
    }

    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.0.sin_cos();
        let square = self.1 * self.1;
        (
            Self(s, c * self.1, c * self.2 - s * square),
            Self(c, -(s * self.1), -(s * self.2) - c * square),
        )
    }
}
