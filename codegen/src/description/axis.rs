//! Directions of axes.
//!
//! In: three numbers with their digits. Out: the same direction with length 1, or why it is none.
//! It lengthens or shortens by no more than the written digits leave open: `0.577 0.577 0.577` is
//! a unit vector, `0 0 2` is a mistake.

use super::Number;

/// The largest departure from length 1 that any digits excuse.
const LARGEST_EXCUSE: f64 = 0.02;

/// Departure from length 1 that comes from rounding alone.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// What is wrong with an axis: the end of a sentence that begins with the axis' name.
pub(super) struct Refusal {
    pub(super) what: String,
    pub(super) hint: String,
}

/// The axis with length 1.
pub(super) fn unit(axis: [Number; 3]) -> Result<[Number; 3], Refusal> {
    let values = axis.map(|number| number.value);
    let largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest == 0.0 {
        return Err(Refusal {
            what: "is zero".to_owned(),
            hint: "give it a direction, such as 0 0 1".to_owned(),
        });
    }
    // Scaled, so that no square overflows or vanishes.
    let scaled = values.map(|x| x / largest);
    let length = largest * scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    let direction = scaled.map(|x| x / (length / largest));

    let open: f64 = axis
        .iter()
        .zip(direction)
        .map(|(number, cosine)| digits_open(number) * cosine.abs())
        .sum();
    let excess = (length - 1.0).abs();
    if excess > open.min(LARGEST_EXCUSE) + ROUNDING {
        let [x, y, z] = direction;
        return Err(Refusal {
            what: format!("has length {length} instead of 1"),
            hint: format!("of length 1 it is {x} {y} {z}"),
        });
    }
    if excess <= ROUNDING {
        return Ok(axis);
    }
    let mut unit = axis;
    for (number, value) in unit.iter_mut().zip(direction) {
        number.value = value;
    }
    Ok(unit)
}

/// By how much the digits of a number leave it open; whole numbers are meant as they stand.
fn digits_open(number: &Number) -> f64 {
    if number.resolution >= 1.0 {
        0.0
    } else {
        number.resolution
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::number;
    use crate::error::Place;

    fn axis(text: &str) -> Result<[f64; 3], (String, String)> {
        let mut words = text.split(' ');
        let numbers = std::array::from_fn(|_| {
            match number::read(words.next().unwrap_or("0"), Place::Unknown) {
                Ok(number) => number,
                Err(refusal) => panic!("{}", refusal.what),
            }
        });
        unit(numbers)
            .map(|axis| axis.map(|number| number.value))
            .map_err(|refusal| (refusal.what, refusal.hint))
    }

    #[test]
    fn a_unit_axis_stays_as_written() {
        assert_eq!(axis("0 0 1"), Ok([0.0, 0.0, 1.0]));
        assert_eq!(axis("0 -1 0"), Ok([0.0, -1.0, 0.0]));
        assert_eq!(axis("0.6 0 0.8"), Ok([0.6, 0.0, 0.8]));
    }

    #[test]
    fn rounded_digits_are_made_good() {
        let third = 1.0 / 3.0_f64.sqrt();
        let found = axis("0.577 0.577 0.577").unwrap();
        assert!(found.iter().all(|x| (x - third).abs() < 1e-15));
        let found = axis("0.7071 0 -0.7071").unwrap();
        assert!((found[0] - 0.5_f64.sqrt()).abs() < 1e-15 && found[1] == 0.0);
    }

    #[test]
    fn zero_and_other_lengths_are_refused() {
        assert_eq!(axis("0 0.0 0").unwrap_err().0, "is zero");
        assert_eq!(
            axis("0 0 2").unwrap_err(),
            (
                "has length 2 instead of 1".to_owned(),
                "of length 1 it is 0 0 1".to_owned()
            )
        );
        assert_eq!(
            axis("1 1 0").unwrap_err().0,
            "has length 1.4142135623730951 instead of 1"
        );
        assert!(axis("0 0 0.9").is_err());
        assert!(axis("1e300 1e300 0").is_err());
        assert!(axis("1e-300 0 0").is_err());
    }
}
