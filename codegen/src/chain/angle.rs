//! Right angles and zeros, as programs and people write them.
//!
//! In: a number as it was written. Out: the quarter turns it means, if π/2 or a multiple of it
//! rounds to the digits that stand there, or if it is a residue: what a program that computed in
//! `f64` left of a right angle or of zero. It never guesses beyond those digits and the last bits.

use std::f64::consts::FRAC_PI_2;

use crate::description::Number;

/// Fewer decimals than these say too little: `1.6` and `3` are not taken for right angles.
const COARSEST: f64 = 0.01;

/// 2⁻⁵⁰, four units of the last place of 1 rad, 1 m or a direction's length: nearer to zero, or to a
/// right angle, is only what was computed to be that. Nobody means 1e-15 m.
const RESIDUE: f64 = 4.0 * f64::EPSILON;

/// Whether a number was written that is nothing but what rounding left of zero.
pub fn is_residue(number: &Number) -> bool {
    number.resolution > 0.0 && number.value != 0.0 && number.value.abs() < RESIDUE
}

/// How many quarter turns the angle means; none where it is not a right angle or not enough of it
/// was written.
pub fn quarters(angle: &Number) -> Option<i64> {
    let quarters = (angle.value / FRAC_PI_2).round();
    if quarters.abs() > 1e6 {
        return None;
    }
    if angle.value == 0.0 || is_residue(angle) {
        return Some(0);
    }
    // Half a unit of the last written digit, and the rounding of both sides to f64.
    let tolerance = angle.resolution / 2.0 * (1.0 + 1e-9) + angle.value.abs() * f64::EPSILON;
    let distance = (angle.value - quarters * FRAC_PI_2).abs();
    let computed = angle.resolution > 0.0 && distance < RESIDUE;
    let written = angle.resolution <= COARSEST && distance <= tolerance;
    let close = quarters != 0.0 && (written || computed);
    #[expect(clippy::cast_possible_truncation, reason = "at most a million")]
    close.then_some(quarters as i64)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::{is_residue, quarters};
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
                assert_eq!(
                    quarters(&rounded(f64::from(count), decimals)),
                    Some(count.into())
                );
            }
        }
        assert_eq!(quarters(&written(FRAC_PI_2, 0.0)), Some(1));
    }

    #[test]
    fn zero_is_no_turn() {
        assert_eq!(quarters(&written(0.0, 1.0)), Some(0));
    }

    #[test]
    fn what_a_program_left_of_a_right_angle_or_of_zero_is_that() {
        for (value, quarters_meant) in [
            (-1.6653e-16, 0),
            (8.8e-16, 0),
            (1.570_796_326_794_896_1, 1),
            (-3.141_592_653_589_793_6, -2),
        ] {
            assert_eq!(quarters(&written(value, 1e-20)), Some(quarters_meant));
        }
        // A number that nobody wrote is what it is.
        assert_eq!(quarters(&written(1e-17, 0.0)), None);
        assert!(!is_residue(&written(0.0, 1.0)) && !is_residue(&written(1e-17, 0.0)));
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
            (9e-16, 1e-17),
            (FRAC_PI_2 - 1e-15, 1e-16),
        ] {
            assert_eq!(quarters(&written(value, resolution)), None, "{value}");
        }
    }
}
