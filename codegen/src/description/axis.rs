//! Directions of axes, and quaternions: numbers whose length means nothing.
//!
//! In: numbers with their digits. Out: the direction of an axis, exactly: as it was written, or times a power of two
//! where its length is far from 1; a quaternion as it was written; a warning where digits do not excuse another length
//! than 1; or why it is none. What the written digits leave open is no doubt: `0.577 0.577 0.577` is a unit vector,
//! `0 0 2` is not.

use super::Number;
use crate::expression::Double;

/// The largest departure from length 1 that any digits excuse.
const LARGEST_EXCUSE: f64 = 0.02;

/// The largest departure from length 1 that nobody needs to hear of, however many digits there are:
/// exporters normalise what they have rounded before.
const UNNOTICED: f64 = 1e-9;

/// What is to be said of an axis: the end of a sentence that begins with the axis' name.
pub(super) struct Remark {
    pub(super) what: String,
    pub(super) hint: String,
}

/// The direction with a length between 1 less [`LARGEST_EXCUSE`] and 2, and what is doubtful about it; or what is
/// wrong with it.
///
/// Nothing is rounded that is more than 10⁻³⁰⁰ of the length: whoever computes with it divides by that, in more
/// digits than numbers of a file have. A power of two makes any axis as large as others, so that what rounding left
/// of zero is known by its size.
pub(super) fn direction(axis: [Number; 3]) -> Result<([Number; 3], Option<Remark>), Remark> {
    let measured = measure(&axis).ok_or_else(|| Remark {
        what: "is zero".to_owned(),
        hint: "give it a direction, such as 0 0 1".to_owned(),
    })?;
    let Measured {
        largest, of_parts, ..
    } = measured;
    let moderate = axis.map(|number| moderate(number, largest, of_parts));
    Ok((moderate, measured.doubt))
}

/// What is doubtful about a quaternion, or wrong with it. Whoever computes with it makes its length 1.
pub(super) fn quaternion(entries: &[Number; 4]) -> Result<Option<Remark>, Remark> {
    let measured = measure(entries).ok_or_else(|| Remark {
        what: "is zero".to_owned(),
        hint: "give it a rotation, such as 0 0 0 1".to_owned(),
    })?;
    Ok(measured.doubt)
}

struct Measured {
    /// The largest magnitude among the numbers.
    largest: f64,
    /// The length of the numbers divided by that.
    of_parts: f64,
    doubt: Option<Remark>,
}

/// Length and direction, to the digits that messages need; none of what is zero.
fn measure<const N: usize>(numbers: &[Number; N]) -> Option<Measured> {
    let values = numbers.map(|number| number.value);
    let largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest == 0.0 {
        return None;
    }
    // Scaled, so that no square overflows or vanishes; for messages and to choose a power of two.
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
    let doubt = (excess > open.min(LARGEST_EXCUSE) + UNNOTICED).then(|| {
        let entries = cosines.map(|entry| entry.to_string());
        Remark {
            what: format!("has length {}: taken with length 1", readable(length)),
            hint: format!("of length 1 it is {}", entries.join(" ")),
        }
    });
    Some(Measured {
        largest,
        of_parts,
        doubt,
    })
}

/// Times the power of two that makes the length of an axis, a product of two numbers, at least 1 and less than 2,
/// where it is not between 0.98 and 2 as it stands.
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
        // Of a number that was read from digits never zero.
        resolution: if number.resolution > 0.0 {
            scaled(number.resolution).max(f64::from_bits(1))
        } else {
            0.0
        },
        place: number.place,
    }
}

/// By how much the digits of a number leave it open; whole numbers are meant as they stand.
fn digits_open(number: &Number) -> f64 {
    if number.resolution >= 1.0 {
        0.0
    } else {
        number.resolution
    }
}

/// A length without hundreds of zeros.
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

    /// The direction that a text means, and what is said of it.
    fn axis(text: &str) -> Result<([f64; 3], Option<String>), String> {
        let mut words = text.split(' ');
        let numbers = std::array::from_fn(|_| {
            match number::read(words.next().unwrap_or("0"), Place::Unknown) {
                Ok(number) => number,
                Err(refusal) => panic!("{}", refusal.what),
            }
        });
        direction(numbers)
            .map(|(axis, doubt)| {
                let said = doubt.map(|doubt| format!("{}; {}", doubt.what, doubt.hint));
                (axis.map(|number| number.value), said)
            })
            .map_err(|refusal| refusal.what)
    }

    fn said(text: &str) -> Option<String> {
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
        // All digits, of numbers that were rounded to twelve before.
        assert_eq!(said_of_length(1.0 - 4e-13), None);
        assert!(said_of_length(1.0 - 4e-9).is_some());
    }

    fn said_of_length(length: f64) -> Option<String> {
        said(&format!("0 0 {length:.17}"))
    }

    #[test]
    fn an_axis_of_another_length_is_a_warning() {
        let of_2 = "has length 2: taken with length 1; of length 1 it is 0 0 1";
        assert_eq!(axis("0 0 2"), Ok(([0.0, 0.0, 1.0], Some(of_2.to_owned()))));
        assert_eq!(
            said("-3e-300 0 4e-300").as_deref(),
            Some("has length 5e-300: taken with length 1; of length 1 it is -0.6 0 0.8")
        );
        assert!(
            said("1.5e308 1.5e308 0")
                .unwrap()
                .starts_with("has length inf")
        );
        assert!(said("0 0 0.9").is_some());
    }

    /// Divided by its length here, it would be another direction by its last digits.
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
