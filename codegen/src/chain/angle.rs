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
    use std::f64::consts::FRAC_PI_2;

    use super::quarters;
    use crate::description::Number;

    fn written(value: f64, resolution: f64) -> Number {
        Number {
            value,
            resolution,
            ..Number::default()
        }
    }

    /// π/2 or a multiple of it with so many decimals, as a person would write it.
    fn rounded(quarters: f64, decimals: usize) -> Number {
        let text = format!("{:.decimals$}", quarters * FRAC_PI_2);
        let resolution = 10_f64.powi(-i32::try_from(decimals).expect("few decimals"));
        written(text.parse().expect("a number"), resolution)
    }

    #[test]
    fn a_right_angle_at_any_sufficient_number_of_digits() {
        for decimals in 2..17 {
            for count in [-3, -2, -1, 1, 2, 3] {
                assert_eq!(quarters(&rounded(f64::from(count), decimals)), Some(count.into()));
            }
        }
        assert_eq!(quarters(&written(FRAC_PI_2, 0.0)), Some(1));
    }

    #[test]
    fn zero_is_no_turn() {
        assert_eq!(quarters(&written(0.0, 1.0)), Some(0));
    }

    #[test]
    fn what_only_comes_close_stays() {
        for (value, resolution) in [
            (FRAC_PI_2 - 9.6e-5, 1e-4),
            (FRAC_PI_2 + 1e-4, 1e-4),
            (FRAC_PI_2 + 1e-2, 1e-2),
            (1.6, 1e-1),
            (2.0, 1.0),
            (3.0, 1.0),
            (1e-9, 1e-9),
        ] {
            assert_eq!(quarters(&written(value, resolution)), None, "{value}");
        }
    }
}
