/// The square root, correctly rounded; NaN of negative numbers.
///
/// No branches. An iteration gives an estimate within one unit in the last place; the remainder, exact in
/// integers, decides the rounding. Zeros, infinity and NaN are selected by bits.
#[inline(never)]
fn sqrt(x: f32) -> f32 {
    const ONE: u32 = 1_u32 << 23;
    const BIAS: u32 = 127_u32;

    let tiny = u32::from(x < f32::MIN_POSITIVE);
    let bits = (x * f32::from_bits((BIAS + 24 * tiny) << 23)).to_bits();
    let exponent = bits >> 23;
    let significand = (bits & (ONE - 1)) | ONE;
    let odd = (exponent + 1) & 1;

    let reduced = f32::from_bits((significand - ONE) | ((BIAS + odd) << 23));
    let first = 0.343 * reduced + 0.687;
    let second = 0.5 * (first + reduced / first);
    let third = 0.5 * (second + reduced / second);
    let near = 0.5 * (third + reduced / third);

    let root = near.to_bits().wrapping_sub(BIAS << 23).wrapping_add(ONE);
    let square = significand << (23 + odd);
    let rest = square.wrapping_sub(root.wrapping_mul(root));
    let above = rest.wrapping_add(root).wrapping_sub(1);
    let root = root + u32::from(above >= 2 * root) - 2 * (above >> 31);
    let root = f32::from_bits((((exponent + BIAS) >> 1) << 23) + (root - ONE));
    let root = root * f32::from_bits((BIAS - 12 * tiny) << 23);

    let positive = x.to_bits().wrapping_sub(1) < f32::INFINITY.to_bits() - 1;
    let has_root = u32::from(positive).wrapping_neg();
    let other = x.to_bits() | (u32::from(x < 0.0) * f32::NAN.to_bits());
    f32::from_bits((root.to_bits() & has_root) | (other & !has_root))
}
