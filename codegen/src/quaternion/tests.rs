use super::of_length_1;
use crate::expression::Double;
use crate::random::Random;
use crate::real::Real;

/// A type of numbers, and the tolerance of lengths.
const TYPES: [(Real, f64); 2] = [(Real::F32, 1e-10), (Real::F64, 1e-22)];

#[test]
fn their_length_is_1_beyond_the_digits_of_their_type() {
    let mut random = Random(3);
    for (scalar, most) in TYPES {
        for small in (0..4).cycle().take(1000) {
            let direction = [(); 4].map(|()| 2.0 * random.unit() - 1.0);
            let entries = of_length_1(direction, small, scalar);
            assert_eq!(entries, entries.map(|entry| scalar.rounded(entry)));
            let squares = entries.map(|entry| Double::from(entry) * Double::from(entry));
            let sum = squares
                .into_iter()
                .fold(Double::from(-1.0), |sum, square| sum + square);
            assert!(sum.to_f64().abs() < most, "{entries:?}: {}", sum.to_f64());
        }
    }
}

#[test]
fn they_have_nearly_the_given_direction() {
    let entries = of_length_1([0.3, 5.0, -0.4, 0.0], 1, Real::F64);
    assert!((entries[0] - 0.6).abs() < 1e-6 && (entries[2] + 0.8).abs() < 1e-6);
    assert!(entries[1].abs() < 1e-3 && entries[3] == 0.0);
}
