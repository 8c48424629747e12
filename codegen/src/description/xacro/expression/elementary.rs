//! Elementary functions by numbers of 106 bits, rounded once.
//!
//! The functions of the platform differ in the last digit from system to system, and the same file must give the same
//! code everywhere.

use crate::expression::Double;

/// The sum of both parts is ln 2 to 106 bits.
const LN_2: [f64; 2] = [std::f64::consts::LN_2, 2.319_046_813_846_299_6e-17];

/// Numbers between the two are scaled without overflow and underflow of their squares.
const MODERATE: [f64; 2] = [1e-140, 1e140];

/// Sine, or NaN beyond 2⁵⁰ rad, where nothing is known.
pub(super) fn sin(x: f64) -> f64 {
    known(Double::from(x).sin_cos().0)
}

/// Cosine, as [`sin`].
pub(super) fn cos(x: f64) -> f64 {
    known(Double::from(x).sin_cos().1)
}

/// Tangent, as [`sin`].
pub(super) fn tan(x: f64) -> f64 {
    let (sine, cosine) = Double::from(x).sin_cos();
    known(sine / cosine)
}

fn known(value: Double) -> f64 {
    if value.is_known() {
        value.to_f64()
    } else {
        f64::NAN
    }
}

/// The angle of a vector, from −π to π.
pub(super) fn atan2(y: f64, x: f64) -> f64 {
    let is_moderate = |value: f64| (MODERATE[0]..MODERATE[1]).contains(&value.abs());
    if is_moderate(x) && is_moderate(y) {
        angle(Double::from(y), Double::from(x))
    } else {
        // Multiples of π/4, or as good as a platform computes a quotient without digits.
        y.atan2(x)
    }
}

pub(super) fn atan(x: f64) -> f64 {
    atan2(x, 1.0)
}

pub(super) fn asin(x: f64) -> f64 {
    if x.abs() < MODERATE[0] {
        x
    } else {
        angle(Double::from(x), leg(x))
    }
}

pub(super) fn acos(x: f64) -> f64 {
    if x == 1.0 {
        0.0
    } else {
        angle(leg(x), Double::from(x))
    }
}

/// √(1 − x²).
fn leg(x: f64) -> Double {
    let (one, x) = (Double::from(1.0), Double::from(x));
    ((one - x) * (one + x)).sqrt()
}

/// The angle of a vector: the platform's, corrected by the angle that is left, whose tangent is itself.
fn angle(y: Double, x: Double) -> f64 {
    let first = Double::from(y.to_f64().atan2(x.to_f64()));
    let (sine, cosine) = first.sin_cos();
    let rest = (y * cosine - x * sine) / (x * cosine + y * sine);
    if rest.is_known() {
        (first + rest).to_f64()
    } else {
        first.to_f64()
    }
}

/// The length of a vector.
pub(super) fn hypot(x: f64, y: f64) -> f64 {
    let is_moderate =
        |value: f64| value == 0.0 || (MODERATE[0]..MODERATE[1]).contains(&value.abs());
    if is_moderate(x) && is_moderate(y) {
        let (x, y) = (Double::from(x), Double::from(y));
        return (x * x + y * y).sqrt().to_f64();
    }
    let larger = x.abs().max(y.abs());
    if larger.is_infinite() {
        return larger;
    }
    let [x, y] = [x / larger, y / larger];
    larger * (x * x + y * y).sqrt()
}

/// eˣ; infinite if it is too large.
pub(super) fn exp(x: f64) -> f64 {
    exponential(Double::from(x)).to_f64()
}

fn exponential(x: Double) -> Double {
    /// Beyond, the result is 0 or infinite.
    const MOST: f64 = 750.0;
    const HALVINGS: i32 = 8;
    const TERMS: u32 = 14;
    let value = x.to_f64();
    if value.is_nan() || value.abs() > MOST {
        return Double::from(if value > 0.0 {
            f64::INFINITY
        } else if value < 0.0 {
            0.0
        } else {
            f64::NAN
        });
    }
    let twos = (value / LN_2[0]).round();
    let rest = LN_2.iter().fold(x, |rest, part| {
        rest - Double::from(*part) * Double::from(twos)
    });
    let small = rest.scaled(-HALVINGS);
    let one = Double::from(1.0);
    let series = (1..=TERMS)
        .rev()
        .fold(one, |sum, n| one + sum * small / Double::from(f64::from(n)));
    let power = (0..HALVINGS).fold(series, |power, _| power * power);
    #[expect(clippy::cast_possible_truncation, reason = "at most 1082")]
    let twos = twos as i32;
    power.scaled(twos)
}

/// The natural logarithm of a positive number.
pub(super) fn ln(x: f64) -> f64 {
    logarithm(x).to_f64()
}

/// The decimal logarithm of a positive number.
pub(super) fn log10(x: f64) -> f64 {
    if x.is_infinite() {
        return x;
    }
    (logarithm(x) / logarithm(10.0)).to_f64()
}

/// The platform's logarithm, corrected by one step of Newton's iteration.
fn logarithm(x: f64) -> Double {
    let first = x.ln();
    if !first.is_finite() {
        return Double::from(first);
    }
    let first = Double::from(first);
    first + (Double::from(x) * exponential(-first) - Double::from(1.0))
}

/// A power. Whole exponents by multiplication; NaN for another exponent of a negative base.
pub(super) fn pow(base: f64, exponent: f64) -> f64 {
    /// Beyond, products lose more than they gain.
    const MOST: f64 = 1024.0;
    if exponent == 0.0 || base == 1.0 {
        return 1.0;
    }
    if exponent.fract() == 0.0 && exponent.abs() <= MOST {
        let (mut power, mut square) = (Double::from(1.0), Double::from(base));
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number of at most 1024"
        )]
        let mut left = exponent.abs() as u32;
        while left > 0 {
            if left % 2 == 1 {
                power = power * square;
            }
            left /= 2;
            if left > 0 {
                square = square * square;
            }
        }
        let power = if exponent < 0.0 {
            Double::from(1.0) / power
        } else {
            power
        };
        if power.is_known() {
            return power.to_f64();
        }
    }
    if base > 0.0 && base.is_finite() && exponent.is_finite() {
        exponential(Double::from(exponent) * logarithm(base)).to_f64()
    } else {
        base.powf(exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_rounded_once() {
        // Correctly rounded values, computed with 60 digits.
        for (found, exact) in [
            (sin(0.3), 0.295_520_206_661_339_55),
            (cos(1e6), 0.936_752_127_533_144_7),
            (tan(1.0), 1.557_407_724_654_902_3),
            (cos(std::f64::consts::FRAC_PI_2), 6.123_233_995_736_766e-17),
            (atan2(1.0, 2.0), 0.463_647_609_000_806_1),
            (atan2(-1.0, -2.0), -2.677_945_044_588_987),
            (asin(0.1), 0.100_167_421_161_559_8),
            (acos(0.3), 1.266_103_672_779_499_2),
            (acos(-1.0), std::f64::consts::PI),
            (exp(1.0), std::f64::consts::E),
            (exp(-10.0), 4.539_992_976_248_485_4e-5),
            (ln(10.0), std::f64::consts::LN_10),
            (log10(1000.0), 3.0),
            (pow(2.0, 0.5), std::f64::consts::SQRT_2),
            (pow(0.1, 3.0), 0.001_000_000_000_000_000_2),
            (pow(10.0, -2.0), 0.01),
        ] {
            assert_eq!(found, exact);
        }
    }

    #[test]
    fn ends_of_the_range_have_values() {
        assert_eq!(exp(1000.0), f64::INFINITY);
        assert_eq!(exp(-1000.0), 0.0);
        assert_eq!(atan2(0.0, -1.0), std::f64::consts::PI);
        assert_eq!(atan2(1e300, 1e300), std::f64::consts::FRAC_PI_4);
        assert_eq!(acos(1.0), 0.0);
        assert_eq!(asin(0.0), 0.0);
        assert!(sin(1e30).is_nan());
        assert!(pow(-8.0, 0.5).is_nan());
        assert_eq!(pow(0.0, 2.0), 0.0);
        assert_eq!(hypot(f64::MAX, 0.0), f64::MAX);
        assert_eq!(hypot(0.0, -2.0), 2.0);
    }
}
