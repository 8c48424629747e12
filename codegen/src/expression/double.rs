//! Double-double arithmetic (106 bits) for everything that is computed while generating, so that a
//! number of the description is rounded once, when it becomes a literal.
//!
//! Algorithms of Dekker (1971) and Knuth in the forms of Joldeș, Muller and Popescu, "Tight and
//! rigorous error bounds for basic building blocks of double-word arithmetic" (ACM TOMS 44, 2017).
//! Beside its value a [`Double`] carries the size of the terms it was made of, so that a difference
//! that is zero but for rounding can be told from a small number.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// An unevaluated sum of two `f64`, and the size of what went into it.
#[derive(Clone, Copy, Debug)]
pub struct Double {
    hi: f64,
    lo: f64,
    size: f64,
}

/// What remains of `size` when only rounding is left of a sum: a few hundred units of 2⁻¹⁰⁶.
const RESIDUE: f64 = 1e-29;

impl Double {
    /// π.
    pub const PI: Self = Self::from_parts(std::f64::consts::PI, 1.224_646_799_147_353_2e-16);
    /// 0.
    pub const ZERO: Self = Self::from_parts(0.0, 0.0);

    const fn from_parts(hi: f64, lo: f64) -> Self {
        Self {
            hi,
            lo,
            size: hi.abs(),
        }
    }

    /// The nearest `f64`.
    #[must_use]
    pub const fn to_f64(self) -> f64 {
        self.hi
    }

    /// The bits that tell two values apart; equal for 0 and −0.
    #[must_use]
    pub fn bits(self) -> (u64, u64) {
        ((self.hi + 0.0).to_bits(), (self.lo + 0.0).to_bits())
    }

    /// Whether nothing but rounding is left of the terms it was made of.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.hi.abs() <= RESIDUE * self.size
    }

    /// Whether it is 1 but for rounding.
    ///
    /// The sine of 1.5707963267948966, a right angle in `f64`, is: it lacks 1.9·10⁻³³, less than the 2⁻¹⁰⁶ that
    /// an operation is off by. The cosine of that angle, 6·10⁻¹⁷, is a number like any other.
    #[must_use]
    pub fn is_one(self) -> bool {
        (self - Self::from(1.0)).hi.abs() <= RESIDUE * self.size.max(1.0)
    }

    /// √x, of a number that is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let root = self.hi.sqrt();
        if root == 0.0 {
            return Self::ZERO;
        }
        let rest = self - Self::product(root, root);
        let (hi, lo) = fast_two_sum(root, rest.hi / (2.0 * root));
        Self {
            hi,
            lo,
            size: self.size.sqrt(),
        }
    }

    /// Sine and cosine, of an angle of moderate size, by Taylor series after reduction to π/16.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        let quarter = Self::PI * Self::from(0.5);
        let quadrants = (self.hi / quarter.hi).round();
        let reduced = self - quarter * Self::from(quadrants);
        // Halved thrice, so that the series needs few terms; the double-angle formulas that undo
        // it use 1 − cos, which loses nothing for small angles.
        let (mut sine, mut versine) = taylor(reduced * Self::from(0.125));
        for _ in 0..3 {
            let cosine = Self::from(1.0) - versine;
            versine = Self::from(2.0) * sine * sine;
            sine = Self::from(2.0) * sine * cosine;
        }
        let cosine = Self::from(1.0) - versine;
        let (sine, cosine) = match quadrants.rem_euclid(4.0) {
            0.0 => (sine, cosine),
            1.0 => (cosine, -sine),
            2.0 => (-sine, -cosine),
            _ => (-cosine, sine),
        };
        (
            Self { size: 1.0, ..sine },
            Self {
                size: 1.0,
                ..cosine
            },
        )
    }

    fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_product(a, b);
        Self {
            hi,
            lo,
            size: hi.abs(),
        }
    }
}

/// Sine and 1 − cosine of a small angle.
fn taylor(x: Double) -> (Double, Double) {
    let mut sums = [Double::ZERO; 2];
    let mut term = x;
    let mut order = 1_u32;
    while term.hi.abs() > 1e-40 {
        let sum = &mut sums[usize::from(order.is_multiple_of(2))];
        *sum = if (order - 1) % 4 < 2 {
            *sum + term
        } else {
            *sum - term
        };
        order += 1;
        term = term * x / Double::from(f64::from(order));
    }
    (sums[0], sums[1])
}

const fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// Dekker's product, which needs no fused operation and so gives the same bits on every host.
const fn two_product(a: f64, b: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0;
    let product = a * b;
    let (a_big, b_big) = (SPLITTER * a, SPLITTER * b);
    let (a_hi, b_hi) = (a_big - (a_big - a), b_big - (b_big - b));
    let (a_lo, b_lo) = (a - a_hi, b - b_hi);
    (
        product,
        ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo,
    )
}

impl From<f64> for Double {
    fn from(value: f64) -> Self {
        Self::from_parts(value, 0.0)
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (sum, error) = two_sum(self.hi, other.hi);
        let (low, low_error) = two_sum(self.lo, other.lo);
        let (sum, error) = fast_two_sum(sum, error + low);
        let (hi, lo) = fast_two_sum(sum, error + low_error);
        Self {
            hi,
            lo,
            size: self.size.max(other.size).max(hi.abs()),
        }
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
            size: self.size,
        }
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (product, error) = two_product(self.hi, other.hi);
        let (hi, lo) = fast_two_sum(product, error + (self.hi * other.lo + self.lo * other.hi));
        Self {
            hi,
            lo,
            size: self.size * other.size,
        }
    }
}

impl Div for Double {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.hi / other.hi;
        let rest = self - other * Self::from(quotient);
        let (hi, lo) = fast_two_sum(quotient, rest.hi / other.hi);
        Self {
            hi,
            lo,
            size: (self.size / other.hi).abs(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Double;

    fn from(value: f64) -> Double {
        Double::from(value)
    }

    #[test]
    fn keeps_what_one_f64_would_lose() {
        let sum = from(1e16) + from(0.1) - from(1e16);
        assert_eq!(sum.to_f64(), 0.1);
    }

    #[test]
    fn division_undoes_multiplication() {
        let third = from(1.0) / from(3.0);
        assert!((third * from(3.0)).is_one());
    }

    #[test]
    fn square_root_squares_back() {
        let root = from(2.0).sqrt();
        assert!((root * root - from(2.0)).is_zero());
    }

    #[test]
    fn pythagoras_holds_to_the_last_digits() {
        for angle in [-7.0, -1.0, 1e-9, 0.3, 1.571, 3.0, 100.0] {
            let (sine, cosine) = from(angle).sin_cos();
            assert!((sine * sine + cosine * cosine).is_one(), "{angle}");
            assert!((sine.to_f64() - angle.sin()).abs() < 2e-16, "{angle}");
            assert!((cosine.to_f64() - angle.cos()).abs() < 2e-16, "{angle}");
        }
    }

    #[test]
    fn sine_of_the_nearest_number_to_pi_is_what_that_number_lacks() {
        let (sine, _) = from(std::f64::consts::PI).sin_cos();
        assert_eq!(sine.to_f64(), 1.224_646_799_147_353_2e-16);
        assert!(!sine.is_zero());
    }

    #[test]
    fn sine_of_the_nearest_number_to_a_right_angle_is_one_and_its_cosine_is_not_zero() {
        let (sine, cosine) = from(std::f64::consts::FRAC_PI_2).sin_cos();
        assert!(sine.is_one());
        assert_eq!(cosine.to_f64(), 6.123_233_995_736_766e-17);
        assert!(!cosine.is_zero());
        // What is further from 1 than rounding takes it is not.
        assert!(!(from(1.0) - from(1e-28)).is_one());
    }

    #[test]
    fn a_cancelled_sum_is_zero_and_a_small_number_is_not() {
        let third = from(1.0) / from(3.0);
        assert!((third + third + third - from(1.0)).is_zero());
        assert!(!from(1e-300).is_zero());
    }
}
