//! User-defined sines, for a build script with `.sin_cos("crate::sines::quick")`.
//!
//! In: an angle \[rad\]. Out: its sine and cosine, faster and less accurate than those of a generated file. The
//! controller does not use them; they are here for comparison.

use core::f32::consts::{FRAC_2_PI, FRAC_PI_2};

/// The largest magnitude of an angle for [`quick`] \[rad\]: a little more than a turn.
pub const QUICK: f32 = 7.0;

/// Sine and cosine of an angle of up to [`QUICK`], with an error of at most 6e-7; NaN gives NaN.
#[must_use]
pub fn quick(angle: f32) -> (f32, f32) {
    // Adding 1.5·2²³ rounds to an integer: the low bits are the number of quadrants.
    let shifted = angle * FRAC_2_PI + ROUND;
    let r = angle - (shifted - ROUND) * FRAC_PI_2;
    let z = r * r;
    // Minimax on |r| ≤ π/4: 5.6e-7 and 3.2e-8.
    let sine = ((8.121_56e-3 * z - 0.166_601_62) * z + 0.999_995) * r;
    let cosine = ((4.165_629e-2 - 1.359_78e-3 * z) * z - 0.499_998_95) * z + 1.0;
    // In odd quadrants the two are exchanged, by masks instead of a branch.
    let quadrant = shifted.to_bits();
    let odd = (quadrant & 1).wrapping_neg();
    let exchanged = (sine.to_bits() ^ cosine.to_bits()) & odd;
    let sine_sign = (quadrant << 30) & SIGN;
    let cosine_sign = (quadrant.wrapping_add(1) << 30) & SIGN;
    (
        f32::from_bits(sine.to_bits() ^ exchanged ^ sine_sign),
        f32::from_bits(cosine.to_bits() ^ exchanged ^ cosine_sign),
    )
}

/// 1.5·2²³: a number of this size has units in its last place.
const ROUND: f32 = 12_582_912.0;

/// The bit of the sign.
const SIGN: u32 = 1 << 31;
