//! Directions of axes, and quaternions: numbers whose length means nothing.
//!
//! In: numbers with their digits. Out: an axis as it was written where its length is nearly 1 and with length 1
//! where not, a quaternion as it was written; and a doubt where digits do not excuse the difference; or why it is
//! none. What the written digits leave open is no doubt: `0.577 0.577 0.577` is a unit vector, `0 0 2` is not.

use super::Number;

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

/// The axis with length 1 or nearly so, and what is doubtful about it; or what is wrong with it.
///
/// Whoever computes with it makes its length 1 to more digits than numbers of a file have.
pub(super) fn unit(axis: [Number; 3]) -> Result<([Number; 3], Option<Remark>), Remark> {
    let measured = measure(&axis).ok_or_else(|| Remark {
        what: "is zero".to_owned(),
        hint: "give it a direction, such as 0 0 1".to_owned(),
    })?;
    let mut unit = axis;
    if (measured.length - 1.0).abs() > LARGEST_EXCUSE {
        for (number, value) in unit.iter_mut().zip(measured.direction) {
            number.value = value;
        }
    }
    Ok((unit, measured.doubt))
}

/// What is doubtful about a quaternion, or wrong with it. Whoever computes with it makes its length 1.
pub(super) fn quaternion(entries: &[Number; 4]) -> Result<Option<Remark>, Remark> {
    let measured = measure(entries).ok_or_else(|| Remark {
        what: "is zero".to_owned(),
        hint: "give it a rotation, such as 0 0 0 1".to_owned(),
    })?;
    Ok(measured.doubt)
}

struct Measured<const N: usize> {
    length: f64,
    direction: [f64; N],
    doubt: Option<Remark>,
}

/// Length and direction, to the digits that messages need; none of what is zero.
fn measure<const N: usize>(numbers: &[Number; N]) -> Option<Measured<N>> {
    let values = numbers.map(|number| number.value);
    let largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest == 0.0 {
        return None;
    }
    // Scaled, so that no square overflows or vanishes.
    let scaled = values.map(|x| x / largest);
    let of_scaled = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    let direction = scaled.map(|x| x / of_scaled);
    let length = largest * of_scaled;

    let open: f64 = numbers
        .iter()
        .zip(direction)
        .map(|(number, cosine)| digits_open(number) * cosine.abs())
        .sum();
    let excess = (length - 1.0).abs();
    let doubt = (excess > open.min(LARGEST_EXCUSE) + UNNOTICED).then(|| {
        let entries = direction.map(|entry| entry.to_string());
        Remark {
            what: format!("has length {}: taken with length 1", readable(length)),
            hint: format!("of length 1 it is {}", entries.join(" ")),
        }
    });
    Some(Measured {
        length,
        direction,
        doubt,
    })
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
        unit(numbers)
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
    fn another_length_is_made_one_and_said() {
        assert_eq!(
            axis("0 0 2"),
            Ok((
                [0.0, 0.0, 1.0],
                Some("has length 2: taken with length 1; of length 1 it is 0 0 1".to_owned())
            ))
        );
        let (found, _) = axis("1 1 0").unwrap();
        assert!((found[0] - 0.5_f64.sqrt()).abs() < 1e-15);
        assert_eq!(
            said("-3e-300 0 4e-300").as_deref(),
            Some("has length 5e-300: taken with length 1; of length 1 it is -0.6 0 0.8")
        );
        assert_eq!(axis("0 1e300 0").unwrap().0, [0.0, 1.0, 0.0]);
        assert!(
            said("1.5e308 1.5e308 0")
                .unwrap()
                .starts_with("has length inf")
        );
        assert!(said("0 0 0.9").is_some());
    }

    #[test]
    fn zero_is_no_direction() {
        assert_eq!(axis("0 0.0 0"), Err("is zero".to_owned()));
        assert_eq!(axis("0 -0 1e-400"), Err("is zero".to_owned()));
    }
}
