//! Literals of C.
//!
//! In: an `f64` that is finite in the scalar type, or a text. Out: the shortest decimal that the type reads as the same
//! number, or a string.

use std::fmt::Write;

use crate::real::Real;

/// Literal in its type; a negative one begins with its sign.
#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to the type is the purpose"
)]
pub(super) fn literal(value: f64, real: Real) -> String {
    match real {
        Real::F32 => format!("{:?}f", value as f32),
        Real::F64 | Real::Generic => format!("{value:?}"),
    }
}

/// Literal of a text, in ASCII: other bytes by their octal numbers.
pub(super) fn string(text: &str) -> String {
    let mut literal = "\"".to_owned();
    for byte in text.bytes() {
        match byte {
            b'"' | b'\\' | b'?' | 0..=31 | 127.. => {
                // Writing to a string cannot fail.
                let _ = write!(literal, "\\{byte:03o}");
            }
            _ => literal.push(char::from(byte)),
        }
    }
    literal + "\""
}

#[cfg(test)]
mod tests {
    use super::{literal, string};
    use crate::real::Real;

    #[test]
    fn texts_are_literals_in_ascii() {
        assert_eq!(string("a \"b\"\\?"), r#""a \042b\042\134\077""#);
        assert_eq!(string("ö1"), r#""\303\2661""#);
    }

    #[test]
    fn every_type_has_its_own_shortest_form() {
        for (value, single, double) in [
            (0.1_f32.into(), "0.1f", "0.10000000149011612"),
            (1e-5, "1e-5f", "1e-5"),
            (-0.0, "-0.0f", "-0.0"),
            (-9.81, "-9.81f", "-9.81"),
            (1e16, "1e16f", "1e16"),
            (3.0, "3.0f", "3.0"),
        ] {
            assert_eq!(literal(value, Real::F32), single);
            assert_eq!(literal(value, Real::Generic), double);
        }
    }
}
