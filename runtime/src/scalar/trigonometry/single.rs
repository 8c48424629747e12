//! Sine and cosine of an angle in single precision, written so that a loop over it vectorises.
//!
//! In: an angle \[rad\]. Out: sine and cosine, within 0.92 units in the last place, on every target:
//! no function of the platform is called, nothing is double, and [`LIMIT`] is the only branch.
//! It needs `core` and a product with a sum, [`Rounding`]; it never panics; NaN and infinite
//! angles give NaN. `tests/reference/trigonometry.py` derives every constant.
#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]

use super::super::rounding::{OfTarget, Rounding};
use core::f32::consts::FRAC_2_PI;

/// The largest magnitude of an angle that [`sin_cos_moderate`] takes \[rad\]: 509 turns.
pub const LIMIT: f32 = 3200.0;

/// Sine and cosine of any angle \[rad\], within 0.92 units in the last place.
#[inline]
#[must_use]
pub fn sin_cos(angle: f32) -> (f32, f32) {
    sin_cos_by::<OfTarget>(angle)
}

/// The same with the given rounding of products in sums.
#[inline]
#[must_use]
pub fn sin_cos_by<R: Rounding>(angle: f32) -> (f32, f32) {
    if angle.abs() <= LIMIT {
        sin_cos_moderate_by::<R>(angle)
    } else {
        sin_cos_wide::<R>(angle)
    }
}

/// Sine and cosine of an angle \[rad\] of magnitude up to [`LIMIT`], without any branch.
///
/// There within 0.92 units in the last place; beyond it the error grows as 6e-8·|angle|, and from
/// 6e6 rad on the results mean nothing and may be infinite or NaN. NaN gives NaN.
#[inline]
#[must_use]
pub fn sin_cos_moderate(angle: f32) -> (f32, f32) {
    sin_cos_moderate_by::<OfTarget>(angle)
}

/// The same with the given rounding of products in sums.
#[inline(always)]
#[must_use]
pub fn sin_cos_moderate_by<R: Rounding>(angle: f32) -> (f32, f32) {
    // Adding ROUND rounds to an integer, which is in the low bits of the sum.
    let shifted = R::f32(angle, FRAC_2_PI, ROUND);
    let quadrants = shifted - ROUND;
    // −quadrants but for its zero, which is +0: times the negative part it keeps an angle of −0.
    let opposite = ROUND - shifted;
    // Cody and Waite: the products with the first two parts are exact, fused or not, and so are
    // the first difference and the remainder of the second.
    let first = R::f32(-quadrants, FRAC_PI_2[0], angle);
    let high = R::f32(opposite, FRAC_PI_2[1], first);
    let remainder = R::f32(opposite, FRAC_PI_2[1], first - high);
    let low = R::f32(-quadrants, FRAC_PI_2[2], remainder);
    in_quadrant::<R>(high, low, shifted.to_bits())
}

/// 1.5·2²³: a number of this size has units in its last place.
const ROUND: f32 = 12_582_912.0;

/// π/2: two parts of 13 bits, so that 2¹¹ times either is exact, and the rest.
const FRAC_PI_2: [f32; 3] = [1.570_800_8, -4.454_516e-6, 6.077_100_6e-11];

/// Coefficients of r³, r⁵, r⁷: relative error of the sine 2⁻²⁷·⁹ for |r| ≤ π/4.
const SINE: [f32; 3] = [-1.666_665_5e-1, 8.332_187e-3, -1.951_789_6e-4];

/// Coefficients of r⁴, r⁶, r⁸: relative error of the cosine 2⁻³³·⁰ for |r| ≤ π/4.
const COSINE: [f32; 3] = [4.166_664_6e-2, -1.388_731e-3, 2.443_232_7e-5];

/// Sine and cosine of `r + low + quadrant·π/2`. `low` is a rounding error of `r`; the two lowest bits of
/// `quadrant` are used.
#[inline(always)]
fn in_quadrant<R: Rounding>(r: f32, low: f32, quadrant: u32) -> (f32, f32) {
    let z = r * r;
    let z_squared = z * z;
    let half = 0.5 * z;

    // r − (−r³(s₃ + s₅r² + …) − (1 − r²/2) low): the sign of a zero r is kept by subtracting.
    let near = R::f32(z, SINE[1], SINE[0]);
    let series = R::f32(z_squared, SINE[2], near);
    let cubic = z * r;
    let sine = r - R::f32(-cubic, series, R::f32(half, low, -low));

    // (1 − r²/2) + (r⁴(c₄ + c₆r² + …) − r·low + the rounding error of 1 − r²/2).
    let leading = 1.0 - half;
    let lost = (1.0 - leading) - half;
    let near = R::f32(z, COSINE[1], COSINE[0]);
    let series = R::f32(z_squared, COSINE[2], near);
    let cosine = leading + R::f32(z_squared, series, R::f32(-r, low, lost));

    // In odd quadrants the two are exchanged, by masks instead of a branch.
    let odd = (quadrant & 1).wrapping_neg();
    let exchanged = (sine.to_bits() ^ cosine.to_bits()) & odd;
    let sine_sign = (quadrant << 30) & SIGN;
    let cosine_sign = (quadrant.wrapping_add(1) << 30) & SIGN;
    (
        f32::from_bits(sine.to_bits() ^ exchanged ^ sine_sign),
        f32::from_bits(cosine.to_bits() ^ exchanged ^ cosine_sign),
    )
}

/// The bit of the sign.
const SIGN: u32 = 1 << 31;

/// Sine and cosine of an angle \[rad\] beyond [`LIMIT`], or NaN.
///
/// Payne and Hanek (1983), in integers: the digits of 2/π that contribute multiples of four
/// quadrants are skipped, and the next 96 leave 32 valid bits of the angle nearest to a multiple
/// of π/2.
#[cold]
#[inline(never)]
fn sin_cos_wide<R: Rounding>(angle: f32) -> (f32, f32) {
    if !angle.is_finite() {
        return (f32::NAN, f32::NAN);
    }
    // |angle| = significand · 2^(exponent − 150).
    let significand = u64::from(angle.to_bits() & ((1 << 23) - 1) | 1 << 23);
    let exponent = (angle.to_bits() >> 23) & 0xff;
    let skipped = exponent.saturating_sub(150 + 2 - 32);
    let digits = |place: u32| significand * u64::from(digits_of_frac_2_pi(skipped + 32 * place));
    // In units of 2⁻⁶² quadrants, modulo four.
    let product = (digits(0) << 32)
        .wrapping_add(digits(1))
        .wrapping_add(digits(2) >> 32);
    let quadrant = low_word((product >> 61).wrapping_add(1) >> 1);
    let fraction = (product << 2).cast_signed() >> 2;

    // Times π/2, to 31 bits.
    let zeros = fraction.unsigned_abs().leading_zeros();
    let normalised = low_word(fraction.unsigned_abs() << zeros >> 32);
    let r = u64::from(normalised) * u64::from(FRAC_PI_2_DIGITS);
    let unit = |places: u32| f32::from_bits((127 - places - zeros) << 23);
    let high = to_f32(low_word(r >> 40)) * unit(21);
    let low = to_f32(low_word(r >> 8)) * unit(53);

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

/// The 32 binary digits of 2/π after the first `skipped`, of which 32 are zeros before the point.
fn digits_of_frac_2_pi(skipped: u32) -> u32 {
    let word = |index: u32| {
        let digits = usize::try_from(index).map(|index| FRAC_2_PI_DIGITS.get(index));
        u64::from(digits.ok().flatten().copied().unwrap_or(0))
    };
    let pair = word(skipped / 32) << 32 | word(skipped / 32 + 1);
    low_word(pair >> (32 - skipped % 32))
}

/// The low 32 bits.
#[expect(clippy::cast_possible_truncation, reason = "the purpose")]
fn low_word(integer: u64) -> u32 {
    integer as u32
}

/// The nearest number.
#[expect(
    clippy::cast_precision_loss,
    reason = "the high part has 24 bits, the low part is a correction"
)]
fn to_f32(integer: u32) -> f32 {
    integer as f32
}

/// π/2 in units of 2⁻³¹.
const FRAC_PI_2_DIGITS: u32 = 0xc90f_daa2;

/// The binary digits of 2/π, after a word of zeros.
const FRAC_2_PI_DIGITS: [u32; 8] = [
    0,
    0xa2f9_836e,
    0x4e44_1529,
    0xfc27_57d1,
    0xf534_ddc0,
    0xdb62_9599,
    0x3c43_9041,
    0xfe51_63ab,
];
