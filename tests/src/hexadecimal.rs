//! Hexadecimal floating-point texts, which lose no bit: `-0x1.8p+3` is −12.
//!
//! In: a finite number, or its text. Out: the other, exactly. It reads only what it writes: one digit, at most
//! thirteen after the point, an exponent of two.

/// Hexadecimal digits of the fraction.
const DIGITS: usize = 13;

/// The text of a number, as by C's `%a`.
///
/// # Panics
/// If the number is infinite or NaN.
#[must_use]
pub fn format(x: f64) -> String {
    assert!(x.is_finite(), "{x} has no digits");
    let sign = if x.is_sign_negative() { "-" } else { "" };
    let bits = x.abs().to_bits();
    let (exponent, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
    let exponent = i64::try_from(exponent).expect("eleven bits");
    let (first, exponent) = match (exponent, fraction) {
        (0, 0) => (0, 0),
        (0, _) => (0, -1022),
        _ => (1, exponent - 1023),
    };
    let digits = format!("{fraction:0DIGITS$x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{first}{point}{digits}p{exponent:+}")
}

/// The number of a text; `None` if it is not one.
#[must_use]
pub fn parse(text: &str) -> Option<f64> {
    let (negative, size) = match text.strip_prefix('-') {
        Some(size) => (true, size),
        None => (false, text),
    };
    let (mantissa, exponent) = size.strip_prefix("0x")?.split_once('p')?;
    let exponent: i64 = exponent.parse().ok()?;
    let (first, digits) = match mantissa.split_once('.') {
        Some((first, digits)) => (first, digits),
        None => (mantissa, ""),
    };
    let are_digits = digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    if digits.len() > DIGITS || !are_digits {
        return None;
    }
    let fraction = u64::from_str_radix(&format!("{digits:0<DIGITS$}"), 16).ok()?;
    let exponent = match (first, exponent) {
        ("0", -1022) => 0,
        ("0", 0) if fraction == 0 => 0,
        ("1", -1022..=1023) => u64::try_from(exponent + 1023).ok()?,
        _ => return None,
    };
    let x = f64::from_bits(exponent << 52 | fraction);
    Some(if negative { -x } else { x })
}

#[cfg(test)]
mod tests {
    use super::{format, parse};
    use crate::states::Random;

    #[test]
    fn known_numbers_have_their_texts() {
        for (x, text) in [
            (0.0, "0x0p+0"),
            (-0.0, "-0x0p+0"),
            (1.0, "0x1p+0"),
            (-12.0, "-0x1.8p+3"),
            (0.1, "0x1.999999999999ap-4"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
            (f64::MIN_POSITIVE, "0x1p-1022"),
            (f64::from_bits(1), "0x0.0000000000001p-1022"),
        ] {
            assert_eq!(format(x), text);
            assert_eq!(parse(text).map(f64::to_bits), Some(x.to_bits()));
        }
    }

    #[test]
    fn every_number_is_read_back_exactly() {
        let mut random = Random::new(1);
        for _ in 0..10_000 {
            let x = f64::from_bits(random.bits());
            if x.is_finite() {
                assert_eq!(parse(&format(x)).map(f64::to_bits), Some(x.to_bits()));
            }
        }
    }

    #[test]
    fn other_texts_are_refused() {
        for text in [
            "",
            "1",
            "0x",
            "0x1",
            "0x2p+0",
            "0x1.p",
            "0x1.00000000000000p+0",
            "0x1.gp+0",
            "0x1.8p+1024",
            "0x0.8p+0",
            "+0x1p+0",
            "0x1p",
        ] {
            assert_eq!(parse(text), None, "{text}");
        }
    }
}
