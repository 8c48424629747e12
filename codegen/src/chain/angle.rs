//! Right angles and zeros, as programs and people write them.
//!
//! In: a number as it was written. Out: the number of quarter turns it means, if π/2 or a multiple of it rounds to the
//! written digits, or if it is a residue: the rounding of a right angle or of zero by a program that computed in `f64`.
//! The same for quaternions, whose entries are ½, √½ and 1 for rotations by right angles. A number that differs beyond
//! those digits and the last bits is kept.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use crate::description::Number;

/// Coarser numbers are not taken for right angles: `1.6` and `3` have too few decimals.
const COARSEST: f64 = 0.01;

/// 2⁻⁵⁰, four units of the last place of 1 rad, 1 m or a direction's length. A number nearer to zero, or to a right
/// angle, must be the result of a computation: nobody means 1e-15 m.
const RESIDUE: f64 = 4.0 * f64::EPSILON;

/// True if a number was written that is a rounding error of zero.
pub fn is_residue(number: &Number) -> bool {
    number.resolution > 0.0 && number.value != 0.0 && number.value.abs() < RESIDUE
}

/// Number of quarter turns that the angle means; `None` if it is not a right angle or was written with too few digits.
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

/// The exact entries of a quaternion that maps axes to axes: four times the square of each, with the sign of the entry,
/// so that ½ is 1, √½ is 2 and 1 is 4. The squares of one quaternion are all the same, or zero.
pub type Squares = [i64; 4];

/// The right angles that the digits of a quaternion mean; `None` for another rotation.
pub fn right_angles(entries: &[Number; 4]) -> Option<Squares> {
    let squares = entries.map(|entry| {
        let values = [0.0, 0.5, FRAC_1_SQRT_2, 1.0].into_iter().zip([0, 1, 2, 4]);
        let mut values = values.filter(|(value, _)| means(&entry, *value));
        values
            .next()
            .map(|(_, square)| if entry.value < 0.0 { -square } else { square })
    });
    let [Some(x), Some(y), Some(z), Some(w)] = squares else {
        return None;
    };
    is_one(&[x, y, z, w]).then_some([x, y, z, w])
}

/// The right angles of a quaternion of any length whose entries have one magnitude or are zero.
pub fn exact_right_angles(entries: &[Number; 4]) -> Option<Squares> {
    let sizes = entries.map(|entry| entry.value.abs());
    let largest = sizes.into_iter().fold(0.0, f64::max);
    let count = sizes.iter().filter(|size| **size == largest).count();
    let equal = sizes.iter().all(|size| *size == 0.0 || *size == largest);
    let square = match count {
        1 => 4,
        2 => 2,
        4 => 1,
        _ => return None,
    };
    let signed = |value: f64| match value {
        0.0 => 0,
        value if value < 0.0 => -square,
        _ => square,
    };
    equal.then(|| entries.map(|entry| signed(entry.value)))
}

/// True if the magnitude of a quaternion's entry means a value.
fn means(entry: &Number, value: f64) -> bool {
    let distance = (entry.value.abs() - value).abs();
    if value == 0.0 {
        return entry.value == 0.0 || is_residue(entry);
    }
    let tolerance = entry.resolution / 2.0 * (1.0 + 1e-9) + value * f64::EPSILON;
    let written = entry.resolution <= COARSEST && distance <= tolerance;
    distance == 0.0 || written || (entry.resolution > 0.0 && distance < RESIDUE)
}

/// True if a quaternion's entry is not exactly the value that it means; always true for √½.
pub fn is_rounded(entry: &Number, square: i64) -> bool {
    let meant = match square.abs() {
        0 => 0.0,
        1 => 0.5,
        2 => return true,
        _ => 1.0,
    };
    entry.value.abs() != meant
}

/// True if the squares are those of a rotation.
fn is_one(squares: &Squares) -> bool {
    let sizes = squares.map(i64::abs);
    let largest = sizes.into_iter().fold(0, i64::max);
    sizes.iter().sum::<i64>() == 4 && sizes.iter().all(|size| *size == 0 || *size == largest)
}

/// The rotation matrix of such a quaternion, with entries −1, 0 and 1.
pub fn rotation([x, y, z, w]: Squares) -> [[f64; 3]; 3] {
    // Four times the product of two entries of the same magnitude.
    let product = |a: i64, b: i64| a * b.signum();
    let twice = [
        [
            2 - product(y, y) - product(z, z),
            product(x, y) - product(z, w),
            product(x, z) + product(y, w),
        ],
        [
            product(x, y) + product(z, w),
            2 - product(x, x) - product(z, z),
            product(y, z) - product(x, w),
        ],
        [
            product(x, z) - product(y, w),
            product(y, z) + product(x, w),
            2 - product(x, x) - product(y, y),
        ],
    ];
    #[expect(clippy::cast_precision_loss, reason = "−2, 0 or 2")]
    twice.map(|row| row.map(|entry| entry as f64 / 2.0))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::{exact_right_angles, is_residue, quarters, right_angles, rotation};
    use crate::description::Number;

    fn written(value: f64, resolution: f64) -> Number {
        Number {
            value,
            resolution,
            ..Number::default()
        }
    }

    /// π/2 or a multiple of it with a number of decimals, as a person would write it.
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
    fn zero_is_no_rotation() {
        assert_eq!(quarters(&written(0.0, 1.0)), Some(0));
    }

    #[test]
    fn residues_of_a_right_angle_or_of_zero_are_recognized() {
        for (value, quarters_meant) in [
            (-1.6653e-16, 0),
            (8.8e-16, 0),
            (1.570_796_326_794_896_1, 1),
            (-3.141_592_653_589_793_6, -2),
        ] {
            assert_eq!(quarters(&written(value, 1e-20)), Some(quarters_meant));
        }
        // A number that was computed, not written, is kept.
        assert_eq!(quarters(&written(1e-17, 0.0)), None);
        assert!(!is_residue(&written(0.0, 1.0)) && !is_residue(&written(1e-17, 0.0)));
    }

    #[test]
    fn numbers_that_only_come_close_are_kept() {
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

    /// A quaternion as it is written.
    fn quaternion(words: [&str; 4]) -> [Number; 4] {
        words.map(|word| {
            let decimals = word.split_once('.').map_or(0, |(_, rest)| rest.len());
            let resolution = 10_f64.powi(-i32::try_from(decimals).expect("few decimals"));
            written(word.parse().expect("a number"), resolution)
        })
    }

    #[test]
    fn quaternions_of_right_angles_are_recognized_by_their_digits() {
        for (words, squares) in [
            (["0.7071068", "0", "0", "0.7071068"], Some([2, 0, 0, 2])),
            (
                ["0.707", "0", "-0.7071067811865475", "0"],
                Some([2, 0, -2, 0]),
            ),
            (
                ["0.5", "-0.5", "0.50", "0.4999999999999999"],
                Some([1, -1, 1, 1]),
            ),
            (["0", "0.0", "1", "0"], Some([0, 0, 4, 0])),
            (["0.000000000000000061", "0", "0", "1"], Some([0, 0, 0, 4])),
            (["0.7", "0", "0", "0.7"], None),
            (["0.70711", "0", "0", "0.70710"], None),
            (["0.7071", "0", "0", "1"], None),
            (["0.7071", "0.7071", "0", "0.7071"], None),
            (["0.5", "0", "0", "0.5"], None),
        ] {
            assert_eq!(right_angles(&quaternion(words)), squares, "{words:?}");
        }
    }

    #[test]
    fn quaternions_with_entries_of_one_magnitude_are_right_angles_at_any_length() {
        for (words, squares) in [
            (["0.7", "0", "0", "-0.7"], Some([2, 0, 0, -2])),
            (["3", "3", "-3", "3"], Some([1, 1, -1, 1])),
            (["0", "0", "0.2", "0"], Some([0, 0, 4, 0])),
            (["1", "1", "0", "1"], None),
            (["0.6", "0", "0", "0.8"], None),
        ] {
            assert_eq!(exact_right_angles(&quaternion(words)), squares, "{words:?}");
        }
    }

    #[test]
    fn rotations_of_right_angles_are_products_of_quarter_turns() {
        // About x, y and z; about their diagonal; half a turn about the diagonal of x and y.
        let none = [0.0; 3];
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let opposite = |row: [f64; 3]| std::array::from_fn(|k| none[k] - row[k]);
        assert_eq!(rotation([2, 0, 0, 2]), [x, opposite(z), y]);
        assert_eq!(rotation([0, -2, 0, -2]), [z, y, opposite(x)]);
        assert_eq!(rotation([0, 0, 2, 2]), [opposite(y), x, z]);
        assert_eq!(rotation([1, 1, 1, 1]), [z, x, y]);
        assert_eq!(rotation([2, 2, 0, 0]), [y, x, opposite(z)]);
        assert_eq!(rotation([0, 0, 0, 4]), [x, y, z]);
    }
}
