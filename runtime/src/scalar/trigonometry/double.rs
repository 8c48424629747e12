//! Sine and cosine of an angle in double precision, written so that a loop over it vectorises.
//!
//! In: an angle \[rad\]. Out: sine and cosine, within 0.9 units in the last place, on every target:
//! no function of the platform is called, and [`LIMIT`] is the only branch.
//! It needs `core` and a product with a sum, [`Rounding`]; it never panics; NaN and infinite
//! angles give NaN. `tests/reference/trigonometry.py` derives every constant.
#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]

use super::super::rounding::{OfTarget, Rounding};
use core::f64::consts::FRAC_2_PI;

/// The largest magnitude of an angle that [`sin_cos_moderate`] takes \[rad\]: 31,830 turns.
pub const LIMIT: f64 = 2e5;

/// Sine and cosine of any angle \[rad\], within 0.9 units in the last place.
#[inline]
#[must_use]
pub fn sin_cos(angle: f64) -> (f64, f64) {
    sin_cos_by::<OfTarget>(angle)
}

/// The same with the given rounding of products in sums.
#[inline]
#[must_use]
pub fn sin_cos_by<R: Rounding>(angle: f64) -> (f64, f64) {
    if angle.abs() <= LIMIT {
        sin_cos_moderate_by::<R>(angle)
    } else {
        sin_cos_wide::<R>(angle)
    }
}

/// Sine and cosine of an angle \[rad\] of magnitude up to [`LIMIT`], without any branch.
///
/// There within 0.9 units in the last place; beyond it the error grows as 1.2e-16·|angle|, and from
/// 1e15 rad on the results mean nothing and may be infinite or NaN. NaN gives NaN.
#[inline]
#[must_use]
pub fn sin_cos_moderate(angle: f64) -> (f64, f64) {
    sin_cos_moderate_by::<OfTarget>(angle)
}

/// The same with the given rounding of products in sums.
#[inline(always)]
#[must_use]
pub fn sin_cos_moderate_by<R: Rounding>(angle: f64) -> (f64, f64) {
    // Adding ROUND rounds to an integer, which is in the low bits of the sum.
    let shifted = R::f64(angle, FRAC_2_PI, ROUND);
    let quadrants = shifted - ROUND;
    // Cody and Waite: the products with the first two parts are exact, fused or not, and so are
    // the first difference and the remainder of the second.
    let first = R::f64(-quadrants, FRAC_PI_2[0], angle);
    let high = R::f64(-quadrants, FRAC_PI_2[1], first);
    let remainder = R::f64(-quadrants, FRAC_PI_2[1], first - high);
    let low = R::f64(-quadrants, FRAC_PI_2[2], remainder);
    in_quadrant::<R>(high, low, shifted.to_bits())
}

/// 1.5·2⁵²: a number of this size has units in its last place.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// π/2: two parts of 36 bits, so that 2¹⁷ times either is exact, and the rest.
const FRAC_PI_2: [f64; 3] = [
    1.570_796_326_792_333_3,
    2.563_344_151_583_955_8e-12,
    1.056_299_906_698_742_8e-23,
];

/// Coefficients of r³, r⁵ … r¹³: relative error of the sine 2⁻⁵⁷·⁹ for |r| ≤ π/4.
const SINE: [f64; 6] = [
    -0.166_666_666_666_666_3,
    0.008_333_333_333_321_84,
    -0.000_198_412_698_293_585_25,
    2.755_731_353_851_189_6e-6,
    -2.505_073_438_862_417_4e-8,
    1.589_543_323_477_850_6e-10,
];

/// Coefficients of r⁴, r⁶ … r¹⁴: relative error of the cosine 2⁻⁶³·⁹ for |r| ≤ π/4.
const COSINE: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_330_7,
    2.480_158_728_896_523e-5,
    -2.755_731_420_307_937e-7,
    2.087_570_313_944_011e-9,
    -1.135_861_698_681_578_8e-11,
];

/// Sine and cosine of `r + low + quadrant·π/2`. `low` is a rounding error of `r`; the two lowest bits of
/// `quadrant` are used.
#[inline(always)]
fn in_quadrant<R: Rounding>(r: f64, low: f64, quadrant: u64) -> (f64, f64) {
    let z = r * r;
    let z_squared = z * z;
    let half = 0.5 * z;

    // r − (−r³(s₃ + s₅r² + …) − (1 − r²/2) low): the sign of a zero r is kept by subtracting.
    let cubic = z * r;
    let sine = r - R::f64(
        -cubic,
        series::<R>(&SINE, z, z_squared),
        R::f64(half, low, -low),
    );

    // (1 − r²/2) + (r⁴(c₄ + c₆r² + …) − r·low + the rounding error of 1 − r²/2).
    let leading = 1.0 - half;
    let lost = (1.0 - leading) - half;
    let small = R::f64(-r, low, lost);
    let cosine = leading + R::f64(z_squared, series::<R>(&COSINE, z, z_squared), small);

    // In odd quadrants the two are exchanged, by masks instead of a branch.
    let odd = (quadrant & 1).wrapping_neg();
    let exchanged = (sine.to_bits() ^ cosine.to_bits()) & odd;
    let sine_sign = (quadrant << 62) & SIGN;
    let cosine_sign = (quadrant.wrapping_add(1) << 62) & SIGN;
    (
        f64::from_bits(sine.to_bits() ^ exchanged ^ sine_sign),
        f64::from_bits(cosine.to_bits() ^ exchanged ^ cosine_sign),
    )
}

/// c₀ + c₁z + … + c₅z⁵, in pairs that are independent of each other.
#[inline(always)]
fn series<R: Rounding>(coefficients: &[f64; 6], z: f64, z_squared: f64) -> f64 {
    let [c_0, c_1, c_2, c_3, c_4, c_5] = *coefficients;
    let near = R::f64(z, c_1, c_0);
    let middle = R::f64(z, c_3, c_2);
    let far = R::f64(z, c_5, c_4);
    R::f64(R::f64(far, z_squared, middle), z_squared, near)
}

/// The bit of the sign.
const SIGN: u64 = 1 << 63;

/// Sine and cosine of an angle \[rad\] beyond [`LIMIT`], or NaN.
///
/// Payne and Hanek (1983), in integers: the digits of 2/π that contribute multiples of four
/// quadrants are skipped, and the next 192 leave 64 valid bits of the angle nearest to a multiple
/// of π/2.
#[cold]
#[inline(never)]
fn sin_cos_wide<R: Rounding>(angle: f64) -> (f64, f64) {
    if !angle.is_finite() {
        return (f64::NAN, f64::NAN);
    }
    // |angle| = significand · 2^(exponent − 1075).
    let significand = u128::from(angle.to_bits() & ((1 << 52) - 1) | 1 << 52);
    let exponent = (angle.to_bits() >> 52) & 0x7ff;
    let skipped = exponent.saturating_sub(1075 + 2 - 64);
    let digits = |place: u64| significand * u128::from(digits_of_frac_2_pi(skipped + 64 * place));
    // In units of 2⁻¹²⁶ quadrants, modulo four.
    let product = (digits(0) << 64)
        .wrapping_add(digits(1))
        .wrapping_add(digits(2) >> 64);
    let quadrant = low_word((product >> 125).wrapping_add(1) >> 1);
    let fraction = (product << 2).cast_signed() >> 2;

    // Times π/2, to 63 bits.
    let zeros = fraction.unsigned_abs().leading_zeros();
    let normalised = low_word(fraction.unsigned_abs() << zeros >> 64);
    let r = u128::from(normalised) * u128::from(FRAC_PI_2_DIGITS);
    let unit = |places: u32| f64::from_bits(u64::from(1023 - places - zeros) << 52);
    let high = to_f64(low_word(r >> 75)) * unit(50);
    let low = to_f64(low_word(r >> 11)) * unit(114);

    let (high, low) = if fraction < 0 {
        (-high, -low)
    } else {
        (high, low)
    };
    if angle < 0.0 {
        in_quadrant::<R>(-high, -low, quadrant.wrapping_neg())
    } else {
        in_quadrant::<R>(high, low, quadrant)
    }
}

/// The 64 binary digits of 2/π after the first `skipped`, of which 64 are zeros before the point.
fn digits_of_frac_2_pi(skipped: u64) -> u64 {
    let word = |index: u64| {
        let digits = usize::try_from(index).map(|index| FRAC_2_PI_DIGITS.get(index));
        u128::from(digits.ok().flatten().copied().unwrap_or(0))
    };
    let pair = word(skipped / 64) << 64 | word(skipped / 64 + 1);
    low_word(pair >> (64 - skipped % 64))
}

/// The low 64 bits.
#[expect(clippy::cast_possible_truncation, reason = "the purpose")]
fn low_word(integer: u128) -> u64 {
    integer as u64
}

/// The nearest number.
#[expect(
    clippy::cast_precision_loss,
    reason = "the high part has 53 bits, the low part is a correction"
)]
fn to_f64(integer: u64) -> f64 {
    integer as f64
}

/// π/2 in units of 2⁻⁶³.
const FRAC_PI_2_DIGITS: u64 = 0xc90f_daa2_2168_c235;

/// The binary digits of 2/π, after a word of zeros.
const FRAC_2_PI_DIGITS: [u64; 20] = [
    0,
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
];
