//! Checks the length of axes and quaternions.
//!
//! An axis is kept as written, or scaled by a power of two if its length is far from 1, so it is not rounded. A length
//! other than 1 is a warning, unless the written digits explain it: `0.577 0.577 0.577` is a unit vector, `0 0 2` is
//! not. Length 0 is an error.

use super::Number;
use crate::expression::Double;

/// Maximum deviation from length 1 that few digits can explain.
const LARGEST_EXCUSE: f64 = 0.02;

/// Maximum deviation from length 1 that is never a warning: exporters normalise rounded numbers.
const UNNOTICED: f64 = 1e-9;

/// A message about an axis: the end of a sentence that begins with the name of the axis.
pub(super) struct Remark {
    pub(super) what: String,
    pub(super) hint: String,
}

/// The direction with a length between 1 − [`LARGEST_EXCUSE`] and 2 and a possible warning; or an error.
///
/// Entries above 10⁻³⁰⁰ of the length are not rounded: users of the direction divide by its length, in more digits than
/// numbers of a file have. After the scaling by a power of two, rounding residues of zero can be recognised by their
/// size.
pub(super) fn direction(axis: [Number; 3]) -> Result<([Number; 3], Option<Remark>), Remark> {
    let measured = measure(&axis).ok_or_else(|| Remark {
        what: "is zero".to_owned(),
        hint: "give it a direction, such as 0 0 1".to_owned(),
    })?;
    let MeasuredLength {
        largest, of_parts, ..
    } = measured;
    let moderate = axis.map(|number| moderate(number, largest, of_parts));
    Ok((moderate, measured.warning))
}

/// A possible warning about a quaternion, or an error. Users of the quaternion normalise it.
pub(super) fn quaternion(entries: &[Number; 4]) -> Result<Option<Remark>, Remark> {
    let measured = measure(entries).ok_or_else(|| Remark {
        what: "is zero".to_owned(),
        hint: "give it a rotation, such as 0 0 0 1".to_owned(),
    })?;
    Ok(measured.warning)
}

struct MeasuredLength {
    /// The largest magnitude of the numbers.
    largest: f64,
    /// The length of the numbers divided by `largest`.
    of_parts: f64,
    warning: Option<Remark>,
}

/// Length and direction, to the precision of messages; `None` if all numbers are 0.
fn measure<const N: usize>(numbers: &[Number; N]) -> Option<MeasuredLength> {
    let values = numbers.map(|number| number.value);
    let largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest == 0.0 {
        return None;
    }
    // Scaled, so that no square overflows or underflows.
    let parts = values.map(|x| x / largest);
    let of_parts = parts.iter().map(|x| x * x).sum::<f64>().sqrt();
    let cosines = parts.map(|x| x / of_parts);
    let length = largest * of_parts;

    let open: f64 = numbers
        .iter()
        .zip(cosines)
        .map(|(number, cosine)| digits_open(number) * cosine.abs())
        .sum();
    let excess = (length - 1.0).abs();
    let warning = (excess > open.min(LARGEST_EXCUSE) + UNNOTICED).then(|| {
        let entries = cosines.map(|entry| entry.to_string());
        Remark {
            what: format!("has length {}, and is normalised", readable(length)),
            hint: format!("the unit vector is {}", entries.join(" ")),
        }
    });
    Some(MeasuredLength {
        largest,
        of_parts,
        warning,
    })
}

/// A number times the power of two that brings the axis to a length in [1, 2), unless the length is between 0.98 and 2.
/// The length is `largest · of_parts`.
fn moderate(number: Number, largest: f64, of_parts: f64) -> Number {
    let length = largest * of_parts;
    if (1.0 - LARGEST_EXCUSE..2.0).contains(&length) {
        return number;
    }
    let up = Double::from(largest).exponent();
    let length = Double::from(largest).scaled(-up).to_f64() * of_parts;
    let times = -up - i32::from(length >= 2.0);
    let scaled = |x: f64| Double::from(x).scaled(times).to_f64();
    Number {
        value: scaled(number.value),
        rest: scaled(number.rest),
        // Never 0 for a number read from digits.
        resolution: if number.resolution > 0.0 {
            scaled(number.resolution).max(f64::from_bits(1))
        } else {
            0.0
        },
        place: number.place,
    }
}

/// Maximum rounding error of a number by its digits; 0 for whole numbers.
fn digits_open(number: &Number) -> f64 {
    if number.resolution >= 1.0 {
        0.0
    } else {
        number.resolution
    }
}

/// A length in scientific notation if it is very large or small.
fn readable(length: f64) -> String {
    if (1e-4..1e6).contains(&length) {
        length.to_string()
    } else {
        format!("{length:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::number;
    use crate::error::Place;

    /// The direction of a text, and the warning.
    fn axis(text: &str) -> Result<([f64; 3], Option<String>), String> {
        let mut words = text.split(' ');
        let numbers = std::array::from_fn(|_| {
            match number::read(words.next().unwrap_or("0"), Place::Unknown) {
                Ok(number) => number,
                Err(refusal) => panic!("{}", refusal.what),
            }
        });
        direction(numbers)
            .map(|(axis, warning)| {
                let remark = warning.map(|warning| format!("{}; {}", warning.what, warning.hint));
                (axis.map(|number| number.value), remark)
            })
            .map_err(|refusal| refusal.what)
    }

    fn remark(text: &str) -> Option<String> {
        axis(text).unwrap().1
    }

    #[test]
    fn a_unit_axis_stays_as_written() {
        assert_eq!(axis("0 0 1"), Ok(([0.0, 0.0, 1.0], None)));
        assert_eq!(axis("0 -1 0"), Ok(([0.0, -1.0, 0.0], None)));
        assert_eq!(axis("0.6 0 0.8"), Ok(([0.6, 0.0, 0.8], None)));
    }

    #[test]
    fn rounded_digits_stay_as_written_without_a_word() {
        assert_eq!(axis("0.577 0.577 0.577"), Ok(([0.577; 3], None)));
        assert_eq!(axis("0.707 0 -0.707"), Ok(([0.707, 0.0, -0.707], None)));
        // All digits, of numbers that were rounded to twelve digits before.
        assert_eq!(remark_of_length(1.0 - 4e-13), None);
        assert!(remark_of_length(1.0 - 4e-9).is_some());
    }

    fn remark_of_length(length: f64) -> Option<String> {
        remark(&format!("0 0 {length:.17}"))
    }

    #[test]
    fn an_axis_of_another_length_is_a_warning() {
        let of_2 = "has length 2, and is normalised; the unit vector is 0 0 1";
        assert_eq!(axis("0 0 2"), Ok(([0.0, 0.0, 1.0], Some(of_2.to_owned()))));
        assert_eq!(
            remark("-3e-300 0 4e-300").as_deref(),
            Some("has length 5e-300, and is normalised; the unit vector is -0.6 0 0.8")
        );
        assert!(
            remark("1.5e308 1.5e308 0")
                .unwrap()
                .starts_with("has length inf")
        );
        assert!(remark("0 0 0.9").is_some());
    }

    /// Division by the length would change the last digits of the direction.
    #[test]
    fn no_entry_of_an_axis_is_rounded() {
        assert_eq!(axis("1 1 0").unwrap().0, [1.0, 1.0, 0.0]);
        assert_eq!(axis("-0.9 -0.527 -0.82").unwrap().0, [-0.9, -0.527, -0.82]);
        assert_eq!(
            axis("0.069 -0.491 0.327").unwrap().0,
            [0.138, -0.982, 0.654]
        );
        assert_eq!(
            axis("0.3 0 -0.4e3").unwrap().0,
            [0.3 / 256.0, 0.0, -400.0 / 256.0]
        );
    }

    #[test]
    fn axes_of_any_size_are_made_moderate() {
        for text in [
            "0 1e300 0",
            "1.5e308 -1.5e308 1.5e308",
            "5e-324 0 0",
            "3e-310 -4e-310 1e-312",
            "0 1e-5 1e-5",
            "0 0 0.9799",
        ] {
            let [x, y, z] = axis(text).unwrap().0;
            let length = (x * x + y * y + z * z).sqrt();
            assert!((1.0..2.0).contains(&length), "{text}: {length}");
        }
    }

    #[test]
    fn zero_is_no_direction() {
        assert_eq!(axis("0 0.0 0"), Err("is zero".to_owned()));
        assert_eq!(axis("0 -0 1e-400"), Err("is zero".to_owned()));
    }
}
