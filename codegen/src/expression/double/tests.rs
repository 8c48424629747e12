//! Tests of the numbers that an enclosure holds; `tests/tests/accuracy/enclosures.rs` draws random ones.

use super::Double;

fn from(value: f64) -> Double {
    Double::from(value)
}

/// True if two enclosures can hold one number.
fn meet(a: Double, b: Double) -> bool {
    (a - b).is_zero()
}

#[test]
fn keeps_digits_that_one_f64_would_lose() {
    let sum = from(1e16) + from(0.1) - from(1e16);
    assert_eq!(sum.to_f64(), 0.1);
}

#[test]
fn division_undoes_multiplication() {
    let third = from(1.0) / from(3.0);
    assert!((third * from(3.0)).is_one());
}

#[test]
fn square_root_squares_back() {
    for square in [2.0, 3e-300, 7e300, 5e-324, 1e-9] {
        let root = from(square).sqrt();
        assert!(root.is_known(), "{square:e}");
        assert!(meet(root * root, from(square)), "{square:e}");
    }
}

#[test]
fn pythagoras_holds_to_the_last_digits() {
    for angle in [-7.0, -1.0, 1e-9, 1e-200, 0.3, 1.571, 3.0, 100.0, 1e15] {
        let (sine, cosine) = from(angle).sin_cos();
        assert!((sine * sine + cosine * cosine).is_one(), "{angle}");
        assert!((sine.to_f64() - angle.sin()).abs() < 2e-16, "{angle}");
        assert!((cosine.to_f64() - angle.cos()).abs() < 2e-16, "{angle}");
        assert!(sine.radius() < 1e-29 && cosine.radius() < 1e-29, "{angle}");
    }
}

#[test]
fn sine_of_the_nearest_number_to_pi_is_the_distance_to_pi() {
    let (sine, _) = from(std::f64::consts::PI).sin_cos();
    assert_eq!(sine.to_f64(), 1.224_646_799_147_353_2e-16);
    assert!(!sine.is_zero());
}

#[test]
fn sine_of_the_nearest_number_to_a_right_angle_is_one_and_its_cosine_is_not_zero() {
    let (sine, cosine) = from(std::f64::consts::FRAC_PI_2).sin_cos();
    assert!(sine.is_one());
    assert_eq!(cosine.to_f64(), 6.123_233_995_736_766e-17);
    assert!(!cosine.is_zero());
    // A number further from 1 than a rounding is not 1.
    assert!(!(from(1.0) - from(1e-28)).is_one());
}

#[test]
fn a_cancelled_sum_is_zero_and_a_small_number_is_not() {
    let third = from(1.0) / from(3.0);
    assert!((third + third + third - from(1.0)).is_zero());
    assert!(!from(1e-300).is_zero());
}

#[test]
fn powers_and_quotients_of_residues_are_numbers_like_any_other() {
    let residue = from(1.110_223e-16);
    let (sine, cosine) = residue.sin_cos();
    assert!(!(sine * sine).is_zero());
    assert!(cosine.is_one());
    assert!(!(sine * sine * sine / from(3.0)).is_zero());
    // A short vector, normalized, has ordinary entries.
    let (x, y) = (from(3e-17), from(4e-17));
    let length = (x * x + y * y).sqrt();
    let (sine, cosine) = (x / length, y / length);
    assert!((sine - from(0.6)).to_f64().abs() < 1e-16);
    assert!(!(sine * from(1e-20)).is_zero() && !cosine.is_zero());
    assert!((sine * sine + cosine * cosine).is_one());
}

#[test]
fn remainders_of_cancellation_give_no_direction() {
    let third = from(1.0) / from(3.0);
    let left = third + third + third - from(1.0 - f64::EPSILON) - from(f64::EPSILON);
    assert!(!left.is_sharp());
    assert!(!(from(1.0) / left).is_known());
    assert!(!(from(1.0) / left).is_zero());
    assert!(!left.sqrt().is_known());
}

#[test]
fn remainders_with_the_digits_of_an_f64_can_be_divisors() {
    let third = from(1.0) / from(3.0);
    let left = third + third + third - (from(1.0) - from(1e-12));
    assert!(!left.is_sharp());
    let quotient = from(1.0) / left;
    assert!(quotient.is_known() && (quotient * left).is_one());
    assert!((left.sqrt().to_f64() - 1e-6).abs() < 1e-21);
}

#[test]
fn an_overflow_is_unknown() {
    let large = from(1e300);
    assert!(!(large * large).is_known());
    assert!(!(large / from(1e-300)).is_known());
    assert!((large * from(1e-300)).is_known());
    assert!((large / large).is_one());
    for unknown in [f64::NAN, f64::INFINITY] {
        assert!(!from(unknown).is_known());
    }
    assert!(!from(1e16).sin_cos().0.is_known());
}
