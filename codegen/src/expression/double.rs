//! Numbers of 106 bits with an error bound, for everything that is computed during generation, so that a number of the
//! description is rounded once, when it becomes a literal.
//!
//! In: numbers of `f64`, exactly. Out: an enclosure of the exact result: a centre, the unevaluated sum of two `f64`,
//! and a radius around it. A number counts as zero only if no number of 106 bits distinguishes it from zero, and not
//! because it is small.
//!
//! Algorithms of Dekker (1971) and Knuth in the forms of Joldeș, Muller and Popescu, "Tight and
//! rigorous error bounds for basic building blocks of double-word arithmetic" (ACM TOMS 44, 2017),
//! which bound the error of a sum by 3u² and of a product by 7u² of the result, u = 2⁻⁵³.

#[cfg(test)]
mod tests;

use std::ops::{Add, Div, Mul, Neg, Sub};

/// An enclosure.
///
/// The exact number lies within `radius` of `hi + lo`, and is `hi + lo` if the radius is 0: so for numbers of `f64`,
/// sums that cancel to zero, and few others. The radius of a sum, product, quotient or root bounds the effect of its
/// operands' radii, its own rounding and underflow. It is infinite where nothing is known: after an overflow, and for
/// a quotient or root of a number of which not even the bits of an `f64` are known. So a radius is never more than an
/// `f64` loses of the terms of its number, and [`Double::is_zero`] drops nothing that an `f64` beside it could hold.
#[derive(Clone, Copy, Debug)]
pub struct Double {
    hi: f64,
    lo: f64,
    radius: f64,
}

/// 2⁻⁵³: the largest relative radius of a divisor or of the operand of a root.
const KNOWN: f64 = f64::from_bits((1023 - 53) << 52);

/// 2⁻⁸⁰: the largest relative radius of an entry of a direction, and the largest radius of an angle.
const SHARP: f64 = f64::from_bits((1023 - 80) << 52);

/// 2⁻¹⁰⁴, 2⁻¹⁰³ and 2⁻¹⁰¹: bounds of the relative errors of a sum, of a product, and of a quotient or root.
const SUM: f64 = f64::from_bits((1023 - 104) << 52);
const PRODUCT: f64 = f64::from_bits((1023 - 103) << 52);
const QUOTIENT: f64 = f64::from_bits((1023 - 101) << 52);

/// 2⁻⁹⁰⁰: below, the lower half of a product may underflow; by less than [`UNDERFLOW`], 2⁻¹⁰⁶⁰.
const SMALL: f64 = f64::from_bits((1023 - 900) << 52);
const UNDERFLOW: f64 = f64::from_bits(1 << 14);

/// Factor of radii for their own roundings.
const SLACK: f64 = 1.0 + 1e-12;

impl Double {
    /// π.
    pub const PI: Self = Self {
        hi: std::f64::consts::PI,
        lo: 1.224_646_799_147_353_2e-16,
        radius: 3e-33,
    };
    /// 0.
    pub const ZERO: Self = Self::exactly(0.0, 0.0);

    const fn exactly(hi: f64, lo: f64) -> Self {
        Self {
            hi,
            lo,
            radius: 0.0,
        }
    }

    /// An enclosure of a number near `hi + lo`; nothing is known if one of the three is NaN or infinite.
    fn around((hi, lo): (f64, f64), radius: f64) -> Self {
        let known = hi.is_finite() && lo.is_finite() && radius.is_finite();
        let radius = if known { radius * SLACK } else { f64::INFINITY };
        Self { hi, lo, radius }
    }

    /// The nearest `f64` to the centre.
    #[must_use]
    pub const fn to_f64(self) -> f64 {
        self.hi
    }

    /// The largest distance of the exact number from the centre; infinite if nothing is known.
    #[must_use]
    pub const fn radius(self) -> f64 {
        self.radius
    }

    /// The bits of the centre, for comparisons; equal for 0 and −0.
    #[must_use]
    pub fn bits(self) -> (u64, u64) {
        ((self.hi + 0.0).to_bits(), (self.lo + 0.0).to_bits())
    }

    /// True if the radius is finite.
    #[must_use]
    pub const fn is_known(self) -> bool {
        self.radius.is_finite()
    }

    /// True if enough bits are known for an entry of a direction. They are not for the remainder of larger numbers that
    /// cancelled up to their last digits.
    #[must_use]
    pub fn is_sharp(self) -> bool {
        self.hi != 0.0 && self.radius <= SHARP * self.hi.abs()
    }

    /// True if it can be a divisor.
    fn divides(self) -> bool {
        self.hi != 0.0 && self.radius <= KNOWN * self.hi.abs()
    }

    /// True if it is zero within 106 bits: every number in the enclosure is within twice the radius of zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.is_known() && self.hi.abs() <= self.radius
    }

    /// True if it is 1 within 106 bits.
    ///
    /// The sine of 1.5707963267948966, a right angle in `f64`, is 1: it differs by 1.9·10⁻³³, less than the 2⁻¹⁰⁶ of
    /// one operation. The cosine of that angle, 6·10⁻¹⁷, is not zero.
    #[must_use]
    pub fn is_one(self) -> bool {
        (self - Self::from(1.0)).is_zero()
    }

    /// −1, 0 or 1.
    #[must_use]
    pub fn sign(self) -> Self {
        let x = self.to_f64();
        Self::from(f64::from(i8::from(x > 0.0) - i8::from(x < 0.0)))
    }

    /// √x.
    #[must_use]
    pub fn sqrt(self) -> Self {
        if self.is_exactly_zero() {
            return Self::ZERO;
        }
        let half = exponent(self.hi).div_euclid(2);
        let x = self.scaled(-2 * half);
        let root = x.hi.sqrt();
        let rest = x - Self::product(root, root);
        let centre = fast_two_sum(root, rest.hi / (2.0 * root));
        let radius = if self.divides() {
            // |√x − √c| ≤ |x − c| / √c
            x.radius / root + QUOTIENT * root
        } else {
            f64::INFINITY
        };
        Self::around(centre, radius).scaled(half)
    }

    /// Sine and cosine, by Taylor series after reduction to a quarter turn. Nothing is known of the sine of an angle
    /// beyond 2⁵⁰ rad, or of one that is not known to 2⁻⁸⁰ rad.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        /// π/2 to 212 bits.
        const QUARTER: [f64; 4] = [
            std::f64::consts::FRAC_PI_2,
            6.123_233_995_736_766e-17,
            -1.497_384_904_859_169_8e-33,
            5.562_271_104_316_826e-50,
        ];
        /// A bound of π/2 minus the four parts.
        const BEYOND: f64 = 3e-66;
        const MOST: f64 = f64::from_bits((1023 + 50) << 52);
        if self.hi.is_nan() || self.hi.abs() > MOST || self.radius > SHARP {
            let unknown = Self::around((0.0, 0.0), f64::INFINITY);
            return (unknown, unknown);
        }
        let quadrants = (self.hi / QUARTER[0]).round();
        let reduced = QUARTER
            .iter()
            .fold(self, |rest, part| rest - Self::product(*part, quadrants));
        let reduced = Self {
            radius: reduced.radius + BEYOND * quadrants.abs(),
            ..reduced
        };
        // Halved thrice, so that the series needs few terms; the double-angle formulas that undo
        // it use 1 − cos, which loses nothing for small angles.
        let (mut sine, mut versine) = taylor(reduced.scaled(-3));
        for _ in 0..3 {
            let cosine = Self::from(1.0) - versine;
            versine = (sine * sine).scaled(1);
            sine = (sine * cosine).scaled(1);
        }
        let cosine = Self::from(1.0) - versine;
        match quadrants.rem_euclid(4.0) {
            0.0 => (sine, cosine),
            1.0 => (cosine, -sine),
            2.0 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }

    /// True if it is a number of `f64`: the sum and the product of two of them are exact.
    fn is_single(self) -> bool {
        self.lo == 0.0 && self.radius == 0.0
    }

    /// True if it is zero, exactly.
    #[must_use]
    pub fn is_exactly_zero(self) -> bool {
        self.hi == 0.0 && self.radius == 0.0
    }

    /// a b of two numbers of `f64`.
    fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = two_product(a, b);
        Self::around((hi, lo), underflow(hi, a == 0.0 || b == 0.0))
    }

    /// n of a number between 2ⁿ and 2ⁿ⁺¹, subnormal or not; −2044 for zero.
    #[must_use]
    pub fn exponent(self) -> i32 {
        let first = exponent(self.hi);
        first + exponent(self.scaled(-first).hi)
    }

    /// 2ⁿ x.
    #[must_use]
    pub fn scaled(self, n: i32) -> Self {
        let times = |x: f64| {
            // In steps, since 2ⁿ itself may be out of range.
            let (mut x, mut left) = (x, n);
            while left != 0 {
                let step = left.clamp(-1000, 1000);
                x *= power_of_two(step);
                left -= step;
            }
            x
        };
        let hi = times(self.hi);
        let lost = underflow(hi, self.is_exactly_zero());
        Self::around((hi, times(self.lo)), times(self.radius) + lost)
    }
}

/// The largest underflow of a product.
fn underflow(hi: f64, exactly_zero: bool) -> f64 {
    if hi.abs() < SMALL && !exactly_zero {
        UNDERFLOW
    } else {
        0.0
    }
}

/// 2ⁿ for an exponent between −1022 and 1023.
fn power_of_two(n: i32) -> f64 {
    let biased = u64::try_from(n + 1023).unwrap_or(0);
    f64::from_bits(biased << 52)
}

/// n of a number between 2ⁿ and 2ⁿ⁺¹; somewhat more for a subnormal one.
fn exponent(x: f64) -> i32 {
    let biased = (x.to_bits() >> 52) & 0x7ff;
    i32::try_from(biased)
        .map_or(0, |biased| biased - 1023)
        .max(-1022)
}

/// Sine and 1 − cosine of a small angle.
fn taylor(x: Double) -> (Double, Double) {
    /// 2⁻¹¹⁶: a bound of the first term that is left out, relative to the angle.
    const LEFT_OUT: f64 = f64::from_bits((1023 - 116) << 52);
    let mut sums = [Double::ZERO; 2];
    let mut term = x;
    let mut order = 1_u32;
    let least = LEFT_OUT * x.hi.abs();
    while term.hi.abs() > least {
        let sum = &mut sums[usize::from(order.is_multiple_of(2))];
        *sum = if (order - 1) % 4 < 2 {
            *sum + term
        } else {
            *sum - term
        };
        order += 1;
        term = term * x / Double::from(f64::from(order));
    }
    // Terms alternate in each sum and shrink; those left out are less than the first of them.
    sums.map(|sum| Double::around((sum.hi, sum.lo), sum.radius + 2.0 * least + x.radius))
        .into()
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
fn two_product(a: f64, b: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0;
    /// 2⁹⁰⁰ and 2⁶⁰: numbers above the first are divided by the second, so that their splitting does not overflow.
    const LARGE: f64 = f64::from_bits((1023 + 900) << 52);
    const STEP: f64 = f64::from_bits((1023 + 60) << 52);
    let product = a * b;
    if !product.is_finite() {
        return (product, f64::NAN);
    }
    if a.abs() > LARGE {
        let (hi, lo) = two_product(a / STEP, b);
        return (hi * STEP, lo * STEP);
    }
    if b.abs() > LARGE {
        return two_product(b, a);
    }
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
        Self::around((value, 0.0), 0.0)
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (sum, error) = two_sum(self.hi, other.hi);
        let (low, low_error) = two_sum(self.lo, other.lo);
        let (sum, error) = fast_two_sum(sum, error + low);
        let (hi, lo) = fast_two_sum(sum, error + low_error);
        let rounding = if self.is_single() && other.is_single() {
            0.0
        } else {
            SUM * hi.abs()
        };
        Self::around((hi, lo), self.radius + other.radius + rounding)
    }
}

impl Neg for Double {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
            ..self
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
        let rounding = if self.is_single() && other.is_single() {
            0.0
        } else {
            PRODUCT * hi.abs()
        };
        // |a| is larger than its upper half by a factor of 1 + u at most, which is part of the slack.
        let radius = self.hi.abs() * other.radius
            + self.radius * (other.hi.abs() + other.radius)
            + rounding
            + underflow(hi, self.is_exactly_zero() || other.is_exactly_zero());
        Self::around((hi, lo), radius)
    }
}

impl Div for Double {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let (up, down) = (exponent(self.hi), exponent(other.hi));
        let (a, b) = (self.scaled(-up), other.scaled(-down));
        let quotient = a.hi / b.hi;
        let rest = a - b * Self::from(quotient);
        let centre = fast_two_sum(quotient, rest.hi / b.hi);
        let radius = if other.divides() {
            // |a/b − c/d| ≤ (|a − c| + |c/d| |b − d|) / |b|, and b equals d up to a part of the slack.
            (a.radius + quotient.abs() * b.radius) / b.hi.abs() + QUOTIENT * quotient.abs()
        } else {
            f64::INFINITY
        };
        Self::around(centre, radius).scaled(up - down)
    }
}
