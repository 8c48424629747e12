//! Reads a number as the nearest `f64`, with one unit of its last written digit.
//!
//! NaN and infinity are errors. A malformed word is never guessed, except in a hint.

use super::Number;
use crate::error::Place;
pub(super) use crate::number::computed;
use crate::wording::quoted;

/// An error of a number: the end of a sentence that begins with the number's name.
pub(super) struct Refusal {
    pub(super) what: String,
    pub(super) hint: Option<&'static str>,
}

/// Reads one word.
pub(super) fn read(word: &str, place: Place) -> Result<Number, Refusal> {
    let Some(last_digit) = last_digit(word) else {
        return Err(refuse(word));
    };
    match word.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(Number {
            value,
            rest: 0.0,
            resolution: power_of_ten(last_digit),
            place,
        }),
        _ => Err(Refusal {
            what: format!("is too large for 64 bits: {}", quoted(word)),
            hint: None,
        }),
    }
}

/// The first character that looks like one of a number but is another: its offset, message and hint.
pub(super) fn look_alike(text: &str) -> Option<(usize, String, &'static str)> {
    let is_one = |(_, letter): &(usize, char)| !letter.is_ascii();
    let mut letters = text.char_indices().filter(is_one);
    letters.find_map(|(at, letter)| {
        let (name, hint) = match letter {
            '\u{a0}' => ("a no-break space", "write a space"),
            '\u{202f}' => ("a narrow no-break space", "write a space"),
            '\u{3000}' => ("an ideographic space", "write a space"),
            '\u{200b}' | '\u{2060}' | '\u{feff}' => ("a space without width", "remove it"),
            '\u{2212}' | '\u{fe63}' | '\u{ff0d}' => {
                ("a minus sign that is not a hyphen", "write -")
            }
            '\u{2010}'..='\u{2015}' => ("a dash", "write -"),
            '\u{ff0b}' => ("a wide plus sign", "write +"),
            '\u{ff0e}' | '\u{3002}' => ("a wide point", "write ."),
            '\u{ff0c}' | '\u{3001}' | '\u{60c}' => (
                "a wide comma",
                "write spaces between numbers, and decimal points in them",
            ),
            '\u{ff10}'..='\u{ff19}' => ("a wide digit", "write 0 to 9"),
            letter if letter.is_whitespace() => ("unusual white space", "write a space"),
            letter if letter.is_numeric() => ("a digit of another script", "write 0 to 9"),
            _ => return None,
        };
        let code = u32::from(letter);
        Some((at, format!("has {name} (U+{code:04X}) in it"), hint))
    })
}

/// Reads a number that may be infinite, for bounds.
pub(super) fn read_bound(word: &str) -> Result<f64, Refusal> {
    let (sign, name) = match word.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, word.strip_prefix('+').unwrap_or(word)),
    };
    if is_infinity(name) {
        return Ok(sign * f64::INFINITY);
    }
    read(word, Place::Unknown).map(|number| number.value)
}

/// The exponent of ten of the last digit. `None` unless the word is a number: sign, digits with at most one point,
/// exponent.
fn last_digit(word: &str) -> Option<i64> {
    let unsigned = word.strip_prefix(['+', '-']).unwrap_or(word);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, read_exponent(exponent)?),
        None => (unsigned, 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(whole) || !digits(fraction) || whole.len() + fraction.len() == 0 {
        return None;
    }
    Some(exponent - i64::try_from(fraction.len()).ok()?)
}

/// An exponent, limited to the range that matters for `f64`.
fn read_exponent(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let size = digits.parse::<i64>().unwrap_or(i64::MAX).min(1_000_000);
    Some(if text.starts_with('-') { -size } else { size })
}

/// 10ⁿ, correctly rounded on every platform, and neither 0 nor infinite: a resolution of 0 marks a number that was not
/// read from digits.
fn power_of_ten(n: i64) -> f64 {
    // Fast path: most numbers have few digits.
    const USUAL: [f64; 13] = [
        1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12,
    ];
    if let Some(power) = usize::try_from(-n).ok().and_then(|n| USUAL.get(n)) {
        return *power;
    }
    let power: f64 = format!("1e{n}").parse().unwrap_or(f64::MAX);
    power.clamp(f64::from_bits(1), f64::MAX)
}

fn is_infinity(name: &str) -> bool {
    name.eq_ignore_ascii_case("inf") || name.eq_ignore_ascii_case("infinity")
}

fn refuse(word: &str) -> Refusal {
    let name = word.trim_start_matches(['+', '-', '.']);
    let (what, hint) = if name.eq_ignore_ascii_case("nan") || name == "1.#QNAN" || name == "1.#IND"
    {
        ("is not finite", None)
    } else if is_infinity(name) || name == "1.#INF" {
        ("is infinite", None)
    } else if word.contains(',') {
        let hint = "write a decimal point, and spaces between numbers";
        ("is not a number", Some(hint))
    } else if word.is_empty() {
        return Refusal {
            what: "is empty".to_owned(),
            hint: None,
        };
    } else if let Some((_, what, hint)) = look_alike(word) {
        let what = format!("{what}: {}", quoted(word));
        return Refusal {
            what,
            hint: Some(hint),
        };
    } else {
        ("is not a number", None)
    };
    Refusal {
        what: format!("{what}: {}", quoted(word)),
        hint,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn resolution(word: &str) -> (f64, f64) {
        match read(word, Place::Unknown) {
            Ok(number) => (number.value, number.resolution),
            Err(refusal) => panic!("{word} {}", refusal.what),
        }
    }

    fn refusal(word: &str) -> String {
        match read(word, Place::Unknown) {
            Ok(number) => panic!("{word} was read as {number:?}"),
            Err(refusal) => refusal.what,
        }
    }

    #[test]
    #[expect(clippy::float_cmp, reason = "reading is exact")]
    fn the_last_written_digit_gives_the_resolution() {
        assert_eq!(resolution("1.2345"), (1.2345, 1e-4));
        assert_eq!(resolution("1.5e-5"), (1.5e-5, 1e-6));
        assert_eq!(resolution("+1"), (1.0, 1.0));
        assert_eq!(resolution("1e-3"), (1e-3, 1e-3));
        assert_eq!(resolution(".5"), (0.5, 0.1));
        assert_eq!(resolution("1."), (1.0, 1.0));
        assert_eq!(resolution("-3.14E2"), (-314.0, 1.0));
        assert_eq!(resolution("0"), (0.0, 1.0));
        assert_eq!(resolution("0e999999999999999999999").0, 0.0);
        assert!(resolution("1e-400").1 > 0.0);
    }

    #[test]
    fn malformed_numbers_are_errors() {
        assert_eq!(refusal("nan"), "is not finite: \"nan\"");
        assert_eq!(refusal("-NaN"), "is not finite: \"-NaN\"");
        assert_eq!(refusal("inf"), "is infinite: \"inf\"");
        assert_eq!(refusal("-Infinity"), "is infinite: \"-Infinity\"");
        assert_eq!(refusal("1e999"), "is too large for 64 bits: \"1e999\"");
        assert_eq!(refusal("0,5"), "is not a number: \"0,5\"");
        assert_eq!(refusal(""), "is empty");
        for word in [
            "abc", "1.2.3", "1e", "e5", ".", "+", "--1", "1 2", "0x10", "1_0", "1\u{b5}",
        ] {
            assert_eq!(refusal(word), format!("is not a number: \"{word}\""));
        }
    }

    #[test]
    fn look_alike_characters_are_named() {
        for (word, what) in [
            ("１", "has a wide digit (U+FF11) in it: \"１\""),
            (
                "\u{2212}1.5",
                "has a minus sign that is not a hyphen (U+2212) in it: \"\u{2212}1.5\"",
            ),
            ("\u{2013}1", "has a dash (U+2013) in it: \"\u{2013}1\""),
            (
                "1\u{a0}2",
                "has a no-break space (U+00A0) in it: \"1\u{a0}2\"",
            ),
            ("٣", "has a digit of another script (U+0663) in it: \"٣\""),
        ] {
            assert_eq!(refusal(word), what);
        }
    }

    #[test]
    fn a_bound_may_be_infinite() {
        assert!(matches!(read_bound("-inf"), Ok(bound) if bound == f64::NEG_INFINITY));
        assert!(matches!(read_bound("Infinity"), Ok(bound) if bound == f64::INFINITY));
        assert!(matches!(read_bound("2.5"), Ok(2.5)));
        assert!(read_bound("nan").is_err());
    }
}
