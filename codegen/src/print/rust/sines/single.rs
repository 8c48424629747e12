/// Sine and cosine of an angle up to 3200 rad (509 turns), within 0.92 units in the last place.
///
/// No branches, so that every angle takes the same time. Beyond 3200 rad the error grows as
/// 6e-8·|angle|, from 6e6 rad on results are meaningless and may be infinite or NaN; NaN and
/// infinite angles give NaN. Cody-Waite reduction to |r| ≤ π/4, then minimax polynomials.
#[inline(never)]
fn sin_cos(angle: f32) -> (f32, f32) {
    const ROUND: f32 = 12_582_912.0;
    const FRAC_PI_2: [f32; 3] = [1.570_800_8, -4.454_516e-6, 6.077_100_6e-11];
    const SINE: [f32; 3] = [-1.666_665_5e-1, 8.332_187e-3, -1.951_789_6e-4];
    const COSINE: [f32; 3] = [4.166_664_6e-2, -1.388_731e-3, 2.443_232_7e-5];

    let shifted = angle * ::core::f32::consts::FRAC_2_PI + ROUND;
    let quadrants = shifted - ROUND;
    let opposite = ROUND - shifted;
    let first = angle - quadrants * FRAC_PI_2[0];
    let r = opposite * FRAC_PI_2[1] + first;
    let remainder = opposite * FRAC_PI_2[1] + (first - r);
    let low = remainder - quadrants * FRAC_PI_2[2];

    let z = r * r;
    let z_squared = z * z;
    let half = 0.5 * z;

    let near = z * SINE[1] + SINE[0];
    let series = z_squared * SINE[2] + near;
    let cubic = z * r;
    let sine = r - ((half * low - low) - cubic * series);

    let leading = 1.0 - half;
    let lost = (1.0 - leading) - half;
    let near = z * COSINE[1] + COSINE[0];
    let series = z_squared * COSINE[2] + near;
    let cosine = leading + (z_squared * series + (lost - r * low));

    let quadrant = shifted.to_bits();
    let odd = (quadrant & 1).wrapping_neg();
    let exchanged = (sine.to_bits() ^ cosine.to_bits()) & odd;
    let sine_sign = (quadrant << 30) & 0x8000_0000;
    let cosine_sign = (quadrant.wrapping_add(1) << 30) & 0x8000_0000;
    (
        f32::from_bits(sine.to_bits() ^ exchanged ^ sine_sign),
        f32::from_bits(cosine.to_bits() ^ exchanged ^ cosine_sign),
    )
}
