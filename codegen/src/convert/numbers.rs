//! Writes numbers in decimal digits.
//!
//! A number that was read from digits keeps them, because a reader takes the digits of a right angle for one. A
//! computed number has the digits of its `f64`.

use crate::description::Number;

/// Digits behind the point beyond which a number is written with an exponent.
const MOST_DECIMALS: i32 = 24;

/// Decimals below which a computed angle could be taken for a right angle by its digits.
const FEW_DECIMALS: usize = 12;

/// A number with its digits.
pub(super) fn text(number: &Number) -> String {
    let value = number.value;
    if number.resolution > 0.0 {
        let unit = format!("{:e}", number.resolution);
        let exponent = unit
            .split_once('e')
            .and_then(|(_, exponent)| exponent.parse().ok());
        let decimals = exponent.map_or(0, |exponent: i32| -exponent);
        if (0..=MOST_DECIMALS).contains(&decimals) {
            let decimals = usize::try_from(decimals).unwrap_or(0);
            let written = format!("{value:.decimals$}");
            if written.parse() == Ok(value) {
                return written;
            }
        }
    }
    plain(value)
}

/// Several numbers.
pub(super) fn texts(numbers: &[Number]) -> String {
    let texts: Vec<String> = numbers.iter().map(text).collect();
    texts.join(" ")
}

/// An angle: that of a computed number has so many digits that it is not taken for a right angle unless it is one.
pub(super) fn angle(number: &Number) -> String {
    let written = text(number);
    let decimals = written.split_once('.').map_or(0, |(_, rest)| rest.len());
    if number.resolution > 0.0 || number.value == 0.0 || decimals >= FEW_DECIMALS {
        written
    } else {
        format!("{:.16}", number.value)
    }
}

/// An `f64` in the fewest digits.
pub(super) fn plain(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-5..1e16).contains(&size) || !size.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::error::Place;
    use crate::number::computed;

    #[test]
    fn numbers_keep_their_digits() {
        let written = |value: f64, resolution: f64| Number {
            value,
            resolution,
            ..Number::default()
        };
        assert_eq!(text(&written(1.2345, 1e-4)), "1.2345");
        assert_eq!(text(&written(1.57, 1e-3)), "1.570");
        assert_eq!(text(&written(-2.0, 1.0)), "-2");
        assert_eq!(text(&written(1.5e-5, 1e-6)), "0.000015");
        assert_eq!(text(&written(2.5e-40, 1e-41)), "2.5e-40");
        // An axis that was scaled by a power of two has no decimal unit.
        assert_eq!(text(&written(0.138, 2e-3)), "0.138");
        assert_eq!(text(&written(3e20, 1e20)), "3e20");
    }

    #[test]
    fn computed_angles_are_right_only_if_they_are() {
        let of = |value: f64| angle(&computed(value, Place::Unknown));
        assert_eq!(of(FRAC_PI_2), "1.5707963267948966");
        assert_eq!(of(1.57), "1.5700000000000001");
        assert_eq!(of(0.0), "0");
    }
}
