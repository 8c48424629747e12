//! Reads products and quotients of numbers and π: `pi/2`, `-3*pi/4`, `2*pi/3`, `1/3`.
//!
//! Results have 106 bits. A plain number keeps its digits. A computed number has resolution 0: it is a right angle
//! exactly if its nearest `f64` is that of a right angle.

use super::Number;
use super::number::{self, Refusal};
use crate::error::Place;
use crate::expression::Double;
use crate::wording::quoted;

/// Maximum length in bytes.
const LONGEST: usize = 1000;

/// Reads a product or quotient of numbers and π without spaces.
pub(super) fn read(word: &str, place: Place) -> Result<Number, Refusal> {
    if !word.contains(['*', '/']) && !word.ends_with("pi") {
        return number::read(word, place);
    }
    if word.len() > LONGEST {
        return Err(refuse("is not a number", word));
    }
    let unsigned = word.strip_prefix(['+', '-']).unwrap_or(word);
    let mut product = Double::from(1.0);
    let mut divides = false;
    let mut rest = unsigned;
    loop {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let factor = factor(&rest[..end], word)?;
        if divides && factor.to_f64() == 0.0 {
            return Err(refuse("divides by zero", word));
        }
        product = if divides {
            product / factor
        } else {
            product * factor
        };
        if end == rest.len() {
            break;
        }
        divides = rest[end..].starts_with('/');
        rest = &rest[end + 1..];
    }
    if !product.is_known() {
        return Err(refuse("is too large for 64 bits", word));
    }
    let signed = if word.starts_with('-') {
        -product
    } else {
        product
    };
    Ok(number::computed(signed, place))
}

fn factor(text: &str, word: &str) -> Result<Double, Refusal> {
    if text == "pi" {
        return Ok(Double::PI);
    }
    match number::read(text, Place::Unknown) {
        Ok(number) => Ok(Double::from(number.value)),
        Err(_) => Err(refuse("is not a number", word)),
    }
}

fn refuse(what: &str, word: &str) -> Refusal {
    Refusal {
        what: format!("{what}: {}", quoted(word)),
        hint: None,
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};

    use super::*;

    fn value(word: &str) -> (f64, f64) {
        match read(word, Place::Unknown) {
            Ok(number) => (number.value, number.resolution),
            Err(refusal) => panic!("{}", refusal.what),
        }
    }

    fn refusal(word: &str) -> String {
        match read(word, Place::Unknown) {
            Ok(number) => panic!("{word} was read as {number:?}"),
            Err(refusal) => refusal.what,
        }
    }

    #[test]
    fn right_angles_are_the_nearest_numbers() {
        assert_eq!(value("pi/2"), (FRAC_PI_2, 0.0));
        assert_eq!(value("-pi/2"), (-FRAC_PI_2, 0.0));
        assert_eq!(value("pi"), (PI, 0.0));
        assert_eq!(value("2*pi"), (TAU, 0.0));
        assert_eq!(value("3*pi/2"), (4.712_388_980_384_69, 0.0));
        assert_eq!(value("pi/3"), (FRAC_PI_3, 0.0));
        assert_eq!(value("1/3"), (1.0 / 3.0, 0.0));
        assert_eq!(value("-0.50"), (-0.5, 0.01));
    }

    #[test]
    fn what_is_no_number_is_refused() {
        assert_eq!(refusal("pi/0"), "divides by zero: \"pi/0\"");
        assert_eq!(refusal("pi/2x"), "is not a number: \"pi/2x\"");
        assert_eq!(refusal("*pi"), "is not a number: \"*pi\"");
        assert_eq!(
            refusal("1e300*1e300"),
            "is too large for 64 bits: \"1e300*1e300\""
        );
        assert!(refusal(&"1/".repeat(501)).starts_with("is not a number"));
        assert_eq!(refusal("Pi"), "is not a number: \"Pi\"");
        assert_eq!(refusal("2pi"), "is not a number: \"2pi\"");
        assert_eq!(refusal("nan"), "is not finite: \"nan\"");
    }
}
