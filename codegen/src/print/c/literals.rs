//! Literals of C.
//!
//! In: an `f64` that is finite in the scalar type. Out: the shortest decimal that the type reads as the same number.

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

#[cfg(test)]
mod tests {
    use super::literal;
    use crate::real::Real;

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
