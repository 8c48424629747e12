//! Right angles written with few digits.
//!
//! In: a number as it was written. Out: the quarter turns it means, if π/2 or a multiple of it
//! rounds to the digits that stand there. It never guesses beyond those digits.

use std::f64::consts::FRAC_PI_2;

use crate::description::Number;

/// Fewer decimals than these say too little: `1.6` and `3` are not taken for right angles.
const COARSEST: f64 = 0.01;

/// How many quarter turns the angle means; none where it is not a right angle or not enough of it
/// was written.
pub fn quarters(angle: &Number) -> Option<i64> {
    let quarters = (angle.value / FRAC_PI_2).round();
    if quarters.abs() > 1e6 {
        return None;
    }
    if angle.value == 0.0 {
        return Some(0);
    }
    // Half a unit of the last written digit, and the rounding of both sides to f64.
    let tolerance = angle.resolution / 2.0 * (1.0 + 1e-9) + angle.value.abs() * f64::EPSILON;
    let exact = quarters * FRAC_PI_2;
    let close =
        quarters != 0.0 && angle.resolution <= COARSEST && (angle.value - exact).abs() <= tolerance;
    #[expect(clippy::cast_possible_truncation, reason = "at most a million")]
    close.then_some(quarters as i64)
}

#[cfg(test)]
mod tests {
    use super::quarters;
    use crate::description::Number;

    fn written(value: f64, resolution: f64) -> Number {
        Number {
            value,
            resolution,
            ..Number::default()
        }
    }

    #[test]
    fn pi_over_two_at_any_sufficient_number_of_digits() {
        for (value, resolution) in [
            (1.57, 1e-2),
            (1.571, 1e-3),
            (1.5708, 1e-4),
            (1.570_796, 1e-6),
            (1.570_796_326_79, 1e-11),
            (1.570_796_326_794_896_6, 1e-16),
            (1.570_796_326_794_896_619, 1e-18),
            (std::f64::consts::FRAC_PI_2, 0.0),
        ] {
            assert_eq!(quarters(&written(value, resolution)), Some(1), "{value}");
            assert_eq!(quarters(&written(-value, resolution)), Some(-1), "{value}");
        }
    }

    #[test]
    fn multiples_and_zero() {
        assert_eq!(quarters(&written(3.141_59, 1e-5)), Some(2));
        assert_eq!(quarters(&written(-4.712_389, 1e-6)), Some(-3));
        assert_eq!(quarters(&written(0.0, 1.0)), Some(0));
    }

    #[test]
    fn what_only_comes_close_stays() {
        for (value, resolution) in [
            (1.5707, 1e-4),
            (1.5709, 1e-4),
            (1.58, 1e-2),
            (1.6, 1e-1),
            (2.0, 1.0),
            (3.0, 1.0),
            (1e-9, 1e-9),
        ] {
            assert_eq!(quarters(&written(value, resolution)), None, "{value}");
        }
    }
}
