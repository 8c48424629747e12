//! A number as written in a file.
//!
//! In: a value, and the number of digits to write. Out: the word, and its meaning, read independently of the generator:
//! its value, whether its digits are those of a rounded right angle, and whether it is a residue in place of zero.

use std::f64::consts::FRAC_PI_2;
use std::fmt;

use crate::big::Big;

/// A word: `0.1575`, `-1.6653e-16`, or, in inline descriptions, a product or quotient such as `pi/2`, `2*pi/7` and
/// `1/3`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written(String);

/// Distance from zero or from a right angle below which a number was computed to be that: 2⁻⁵⁰.
const RESIDUE: f64 = 4.0 * f64::EPSILON;

/// The interpretation of digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// An angle with the digits of a rounded right angle is one; angles, offsets and entries of axes below 2⁻⁵⁰ are
    /// zero.
    Digits,
    /// Every number is exactly as written.
    Exact,
    /// Numbers were computed, not written: the `f64` nearest to a right angle is one.
    Computed,
}

impl Written {
    /// A word.
    pub fn new(word: impl Into<String>) -> Self {
        Self(word.into())
    }

    /// 0.
    #[must_use]
    pub fn zero() -> Self {
        Self::new("0")
    }

    /// A value with so many significant digits, with an exponent if it is small or large.
    ///
    /// # Panics
    /// If the value is not finite.
    #[must_use]
    pub fn digits(value: f64, digits: usize) -> Self {
        let word = format!("{value:.0$e}", digits.max(1) - 1);
        let rounded: f64 = word.parse().expect("a number was printed");
        let moderate = rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs());
        Self(if moderate { rounded.to_string() } else { word })
    }

    /// A value with so many decimals.
    #[must_use]
    pub fn decimals(value: f64, decimals: usize) -> Self {
        Self(format!("{value:.decimals$}"))
    }

    /// The nearest `f64`.
    ///
    /// # Panics
    /// If the word is not a number.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.number().to_f64()
    }

    /// The number; each factor that is written in digits is rounded to `f64`.
    ///
    /// # Panics
    /// If the word is not a number.
    #[must_use]
    pub fn number(&self) -> Big {
        let factor = |word: &str| match word {
            "pi" => Big::pi(),
            digits => Big::new(digits.parse().expect("a number was written")),
        };
        let (sign, rest) = match self.0.strip_prefix('-') {
            Some(rest) if self.is_computed() => (-Big::one(), rest),
            _ => (Big::one(), self.0.as_str()),
        };
        let end = |rest: &str| rest.find(['*', '/']).unwrap_or(rest.len());
        let (first, mut rest) = rest.split_at(end(rest));
        let mut product = sign * factor(first);
        while let Some(operation) = rest.chars().next() {
            let (next, after) = rest[1..].split_at(end(&rest[1..]));
            product = if operation == '*' {
                product * factor(next)
            } else {
                product / factor(next)
            };
            rest = after;
        }
        product
    }

    /// True for a product or quotient.
    fn is_computed(&self) -> bool {
        self.0.contains(['*', '/']) || self.0.ends_with("pi")
    }

    /// The number that an offset means, or an entry of a direction scaled by a power of two.
    #[must_use]
    pub fn meant(&self, reading: Reading, times: f64) -> Big {
        let residue = reading == Reading::Digits && (self.value() * times).abs() < RESIDUE;
        if residue && !self.is_computed() {
            Big::zero()
        } else {
            self.number()
        }
    }

    /// True for 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.value() == 0.0
    }

    /// The same number with the other sign.
    #[must_use]
    pub fn negated(&self) -> Self {
        if self.is_zero() {
            return self.clone();
        }
        match self.0.strip_prefix('-') {
            Some(rest) => Self::new(rest),
            None => Self(format!("-{}", self.0)),
        }
    }

    /// Sine and cosine of the angle, to 256 bits.
    #[must_use]
    pub fn sin_cos(&self, reading: Reading) -> (Big, Big) {
        let Some(quarters) = self.quarters(reading) else {
            return self.meant(reading, 1.0).sin_cos();
        };
        let sine = |quarters: i64| {
            Big::new(match quarters.rem_euclid(4) {
                1 => 1.0,
                3 => -1.0,
                _ => 0.0,
            })
        };
        (sine(quarters), sine(quarters + 1))
    }

    /// The number of right angles that the angle means; `None` for other angles.
    #[must_use]
    pub fn quarters(&self, reading: Reading) -> Option<i64> {
        let value = self.value();
        let quarters = (value / FRAC_PI_2).round();
        if quarters == 0.0 || quarters.abs() > 1e6 {
            return None;
        }
        let right = quarters * FRAC_PI_2;
        let close = (value - right).abs() < RESIDUE && reading == Reading::Digits;
        let meant = if self.is_computed() || reading == Reading::Computed || close {
            right
        } else if reading == Reading::Exact {
            return None;
        } else {
            let decimals = self.written_decimals().filter(|&decimals| decimals >= 2)?;
            format!("{right:.decimals$}").parse().ok()?
        };
        #[expect(clippy::cast_possible_truncation, reason = "at most a million")]
        (close || (value - meant).abs() <= f64::EPSILON * value.abs()).then_some(quarters as i64)
    }

    /// The number of decimals, with the exponent; `None` if negative.
    fn written_decimals(&self) -> Option<usize> {
        let (mantissa, exponent) = self.0.split_once('e').unwrap_or((&self.0, "0"));
        let fraction = mantissa.split_once('.').map_or(0, |(_, rest)| rest.len());
        let exponent: i64 = exponent.parse().ok()?;
        usize::try_from(i64::try_from(fraction).ok()? - exponent).ok()
    }
}

impl fmt::Display for Written {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::{Reading, Written};

    #[test]
    fn right_angles_are_recognised_by_their_digits() {
        for (word, quarters) in [
            ("1.57", Some(1)),
            ("1.5708", Some(1)),
            ("-1.571", Some(-1)),
            ("3.1415927", Some(2)),
            ("1.5708e0", Some(1)),
            ("157.08e-2", Some(1)),
            ("1.57079632679489662", Some(1)),
            ("pi/2", Some(1)),
            ("-pi", Some(-2)),
            ("3*pi/2", Some(3)),
            ("pi/3", None),
            ("1570796.327", Some(1_000_000)),
            ("1.5707963267948961", Some(1)),
            ("1.5707", None),
            ("1.6", None),
            ("1.570797", None),
            ("3", None),
            ("1e-9", None),
            ("0", None),
        ] {
            let written = Written::new(word);
            assert_eq!(written.quarters(Reading::Digits), quarters, "{word}");
        }
        assert_eq!(Written::new("1.5708").quarters(Reading::Exact), None);
        assert_eq!(Written::new("pi/2").quarters(Reading::Exact), Some(1));
        assert_eq!(Written::new("1.5708").quarters(Reading::Computed), None);
    }

    #[test]
    fn residues_are_zero_unless_exact() {
        let residue = Written::new("-1.6653e-16");
        let meant = |word: &Written, reading, times| word.meant(reading, times).to_f64();
        assert_eq!(meant(&residue, Reading::Digits, 1.0), 0.0);
        assert_eq!(meant(&residue, Reading::Exact, 1.0), -1.6653e-16);
        assert_eq!(meant(&Written::new("1e-15"), Reading::Digits, 1.0), 1e-15);
        assert_eq!(meant(&Written::new("1e-14"), Reading::Digits, 0.0625), 0.0);
    }

    #[test]
    fn words_have_the_given_number_of_digits() {
        for (value, digits, word) in [
            (1.0 / 3.0, 3, "0.333"),
            (-1.6653e-16, 5, "-1.6653e-16"),
            (1e-9, 1, "1e-9"),
            (2.0, 6, "2"),
            (0.0, 3, "0"),
        ] {
            assert_eq!(Written::digits(value, digits).to_string(), word);
        }
        assert_eq!(
            Written::decimals(std::f64::consts::FRAC_PI_2, 4).to_string(),
            "1.5708"
        );
    }
}
