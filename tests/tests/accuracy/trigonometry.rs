//! Sines and cosines of the runtime, fused and unfused, compared with 256 bits.
//!
//! In: random angles, angles next to multiples of π/2, tiny and huge ones. Out: failed assertions. The 256 bits
//! themselves are compared with a table of another library, by `reference/trigonometry.py`.

use core::array::from_fn;
use core::f64::consts::FRAC_PI_2;
use core::ops::RangeInclusive;
use core::str::FromStr;
use dashu_float::round::mode::HalfEven;
use dashu_float::{DBig, FBig};
use homogen::Scalar;
use homogen::trigonometry::{double, sin_cos_all_f32, sin_cos_all_f64, sin_cos_each, single};
use homogen_tests::fused_sines;
use homogen_tests::states::Random;

/// A number of 256 bits.
type Big = FBig<HalfEven>;

/// Limit in ulp; the worst of 4·10⁷ angles is 0.806, fused or not.
const DOUBLE_LIMIT: f64 = 0.85;

/// Limit in ulp; the worst of all finite angles is 0.917, fused or not.
const SINGLE_LIMIT: f64 = 0.92;

#[test]
fn the_256_bits_agree_with_a_second_source() {
    let tolerance = big(1e-68);
    for (angle, sine, cosine) in table() {
        let found = sin_cos(angle);
        for (found, expected) in [(found.0, sine), (found.1, cosine)] {
            let error = relative(&found, &expected);
            assert!(error <= tolerance, "{angle:e}: {found} {expected}");
        }
    }
}

#[test]
fn double_precision_agrees_with_the_table() {
    for (angle, sine, cosine) in table() {
        let found = double::sin_cos(angle);
        assert_within(angle, found, (&sine, &cosine), DOUBLE_LIMIT);
    }
}

#[test]
fn double_precision_is_within_its_limit_at_random_angles() {
    let mut random = Random::new(1);
    for _ in 0..1_000 {
        check(in_range(&mut random, -FRAC_PI_2..=FRAC_PI_2));
        check(in_range(&mut random, -double::LIMIT..=double::LIMIT));
        let exponent = in_range(&mut random, -60.0..=60.0);
        check(exponent.exp2());
        check(finite(&mut random));
    }
}

/// Angles at which sine or cosine nearly vanish, or which are near the border of a quadrant.
#[test]
fn large_angles_are_within_the_limit() {
    // The angles of f64 nearest to a multiple of π/2, of all and of those up to `double::LIMIT`.
    check(6_381_956_970_095_103.0 * 797_f64.exp2());
    for quadrant in [29.0, 58_285.0, 116_570.0, 87_981.0, 58_654.0, 117_308.0] {
        check(quadrant * FRAC_PI_2);
    }
    let mut random = Random::new(2);
    for exponent in 0..=8 {
        for _ in 0..100 {
            let octant = in_range(&mut random, 0.0..=10_f64.powi(exponent)).round();
            check(octant * FRAC_PI_2 / 2.0);
            check((octant * FRAC_PI_2 / 2.0).next_up());
        }
    }
    for angle in [double::LIMIT, double::LIMIT.next_up(), 1e22, f64::MAX] {
        check(angle);
        check(-angle);
    }
}

#[test]
fn double_precision_is_within_its_limit_at_the_worst_known_angles() {
    for bits in [
        0x3fe9_ef7d_cd5f_4a90_u64,
        0xbfe9_6410_d4d8_e122,
        0xc00f_5f07_256d_d4ca,
        0x4104_befb_e90f_71db,
        0xc016_2dd3_560d_f172,
        0x4108_764c_72aa_9de6,
        0x4108_8c7c_72cd_2424,
        0x4109_20ba_ae72_515c,
        0x6bb0_06a1_109c_49c9,
    ] {
        check(f64::from_bits(bits));
    }
}

/// `cargo bench --bench sincos -- --exhaustive` tests all of them.
#[test]
fn single_precision_is_within_its_limit_at_every_997th_angle() {
    for bits in (0..f32::INFINITY.to_bits()).step_by(997) {
        check_single(f32::from_bits(bits));
    }
}

#[test]
fn single_precision_is_within_its_limit_at_the_worst_known_angles() {
    for bits in [
        0x452d_eaa7,
        0x4543_38a9,
        0x4547_a396,
        0x5cd4_ae48,
        0x6226_1561,
    ] {
        check_single(f32::from_bits(bits));
    }
    for octant in 0..=5_000_u16 {
        let angle = rounded(f64::from(octant) * FRAC_PI_2 / 2.0);
        check_single(angle.next_down());
        check_single(angle);
        check_single(angle.next_up());
    }
}

#[test]
fn the_sine_is_odd_and_the_cosine_even() {
    let mut random = Random::new(3);
    for _ in 0..10_000 {
        let angle = finite(&mut random);
        let ((s, c), (minus_s, minus_c)) = (double::sin_cos(angle), double::sin_cos(-angle));
        assert_eq!(
            (s.to_bits(), c),
            ((-minus_s).to_bits(), minus_c),
            "{angle:e}"
        );
        let angle = rounded(angle);
        let ((s, c), (minus_s, minus_c)) = (single::sin_cos(angle), single::sin_cos(-angle));
        if angle.is_finite() {
            assert_eq!(
                (s.to_bits(), c),
                ((-minus_s).to_bits(), minus_c),
                "{angle:e}"
            );
        }
    }
}

#[test]
fn tiny_angles_are_their_own_sine() {
    for angle in [0.0, -0.0, 5e-324, -5e-324, 1e-310, -f64::MIN_POSITIVE, 1e-9] {
        let (sine, cosine) = double::sin_cos(angle);
        assert_eq!(
            (sine.to_bits(), cosine),
            (angle.to_bits(), 1.0),
            "{angle:e}"
        );
    }
    for angle in [0.0, -0.0, 1e-45, -1e-45, 1e-40, -f32::MIN_POSITIVE, 1e-5] {
        let (sine, cosine) = single::sin_cos(angle);
        assert_eq!(
            (sine.to_bits(), cosine),
            (angle.to_bits(), 1.0),
            "{angle:e}"
        );
    }
}

#[test]
fn infinities_and_nan_give_nan() {
    let angles = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let (sines, cosines) = sin_cos_all_f64(angles);
    assert!(sines.iter().chain(&cosines).all(|x| x.is_nan()));
    let (sines, cosines) = sin_cos_all_f32(angles.map(rounded));
    assert!(sines.iter().chain(&cosines).all(|x| x.is_nan()));
    assert!(double::sin_cos_moderate(f64::NAN).0.is_nan());
    assert!(single::sin_cos_moderate(f32::NAN).1.is_nan());
}

/// The result of an angle depends neither on the number of angles nor on a huge one among them.
#[test]
fn all_together_equal_one_by_one() {
    check_together::<0>();
    check_together::<1>();
    check_together::<2>();
    check_together::<7>();
    check_together::<8>();
    check_together::<9>();
    check_together::<29>();
}

/// The alternative gives the bits of the platform's function.
#[test]
fn each_is_the_platforms() {
    let angles = [0.3, -2.0, 1e6];
    let (sines, cosines) = sin_cos_each(angles);
    for i in 0..angles.len() {
        assert_eq!((sines[i], cosines[i]), angles[i].sin_cos());
    }
}

/// The errors that the documentation of `sin_cos_moderate` states beyond the limit.
#[test]
fn errors_beyond_the_limit_are_as_documented() {
    let mut random = Random::new(4);
    for _ in 0..200 {
        let exponent = in_range(&mut random, double::LIMIT.log2()..=1e14_f64.log2());
        let angle = exponent.exp2();
        let (sine, cosine) = double::sin_cos_moderate(angle);
        let (expected_sine, expected_cosine) = sin_cos(angle);
        for (found, expected) in [(sine, expected_sine), (cosine, expected_cosine)] {
            let error = (big(found) - expected).to_f64().value().abs();
            assert!(error <= 1.2e-16 * angle, "{angle:e}: {error:e}");
        }
        let angle = rounded(in_range(&mut random, 3_200_f64.log2()..=1e6_f64.log2()).exp2());
        let (sine, cosine) = single::sin_cos_moderate(angle);
        let (expected_sine, expected_cosine) = f64::from(angle).sin_cos();
        for (found, expected) in [(sine, expected_sine), (cosine, expected_cosine)] {
            let error = (f64::from(found) - expected).abs();
            assert!(error <= 6e-8 * f64::from(angle), "{angle:e}: {error:e}");
        }
    }
}

fn check_together<const N: usize>() {
    let mut random = Random::new(5);
    for repetition in 0..50 {
        let mut angles: [f64; N] = from_fn(|_| in_range(&mut random, -4.0..=4.0));
        if repetition % 2 == 1 {
            for angle in angles.iter_mut().skip(repetition % 5).step_by(4) {
                *angle = in_range(&mut random, -1e9..=1e9);
            }
        }
        let (sines, cosines) = f64::sin_cos_all(angles);
        for i in 0..N {
            assert_eq!((sines[i], cosines[i]), double::sin_cos(angles[i]));
        }
        let angles = angles.map(rounded);
        let (sines, cosines) = f32::sin_cos_all(angles);
        for i in 0..N {
            assert_eq!((sines[i], cosines[i]), single::sin_cos(angles[i]));
        }
    }
}

fn check(angle: f64) {
    let (sine, cosine) = sin_cos(angle);
    for found in [double::sin_cos(angle), fused_sines::double::sin_cos(angle)] {
        assert_within(angle, found, (&sine, &cosine), DOUBLE_LIMIT);
    }
}

fn assert_within(angle: f64, found: (f64, f64), expected: (&Big, &Big), limit: f64) {
    for (found, expected) in [(found.0, expected.0), (found.1, expected.1)] {
        let error = (big(found) - expected).to_f64().value().abs() / last_place(found);
        assert!(error <= limit, "{angle:e}: {found:e} is off by {error} ulp");
    }
}

/// The standard library's double precision is accurate enough to measure single precision.
fn check_single(angle: f32) {
    let (sine, cosine) = single::sin_cos(angle);
    let (fused_sine, fused_cosine) = fused_sines::single::sin_cos(angle);
    let (expected_sine, expected_cosine) = f64::from(angle).sin_cos();
    for (found, expected) in [
        (sine, expected_sine),
        (cosine, expected_cosine),
        (fused_sine, expected_sine),
        (fused_cosine, expected_cosine),
    ] {
        let unit = (f64::from(f32::EPSILON) * power_of_two(expected)).max(1e-45);
        let error = (f64::from(found) - expected).abs() / unit;
        assert!(
            error <= SINGLE_LIMIT,
            "{angle:e}: {found:e} is off by {error} ulp"
        );
    }
}

/// The ulp of `x`.
fn last_place(x: f64) -> f64 {
    (f64::EPSILON * power_of_two(x)).max(5e-324)
}

/// The largest power of two up to `x`, or 0.
fn power_of_two(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & f64::INFINITY.to_bits())
}

/// Sine and cosine of the exact value of `angle`, in 256 bits.
fn sin_cos(angle: f64) -> (Big, Big) {
    big(angle).sin_cos()
}

/// The number in 256 bits.
fn big(x: f64) -> Big {
    let exact = Big::try_from(x).expect("the number is finite");
    exact.with_precision(256).value()
}

fn relative(found: &Big, expected: &Big) -> Big {
    let error = (found - expected) / expected;
    if error < Big::ZERO { -error } else { error }
}

/// Angle, sine and cosine, from an independent library.
fn table() -> impl Iterator<Item = (f64, Big, Big)> {
    let lines = include_str!("../../reference/trigonometry.txt").lines();
    lines.map(|line| {
        let mut words = line.split(' ');
        let mut word = || words.next().expect("a line has three words");
        let angle = u64::from_str_radix(word(), 16).expect("the bits of an angle");
        (f64::from_bits(angle), decimal(word()), decimal(word()))
    })
}

fn decimal(digits: &str) -> Big {
    let exact = DBig::from_str(digits).expect("a decimal number");
    let precise = exact.with_precision(90).value();
    precise
        .with_base_and_precision::<2>(256)
        .value()
        .with_rounding()
}

#[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
fn rounded(x: f64) -> f32 {
    x as f32
}

fn in_range(random: &mut Random, range: RangeInclusive<f64>) -> f64 {
    let fraction = f64::from_bits(random.bits() >> 12 | 1_f64.to_bits()) - 1.0;
    range.start() + (range.end() - range.start()) * fraction
}

/// A random finite number with uniformly distributed bits.
fn finite(random: &mut Random) -> f64 {
    loop {
        let number = f64::from_bits(random.bits());
        if number.is_finite() {
            return number;
        }
    }
}
