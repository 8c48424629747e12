/// The square root, correctly rounded; NaN of negative numbers.
///
/// No branches. An iteration gives an estimate within one unit in the last place; the remainder, exact in
/// integers, decides the rounding. Zeros, infinity and NaN are selected by bits.
#[inline(never)]
fn sqrt(x: f64) -> f64 {
    const ONE: u64 = 1_u64 << 52;
    const BIAS: u64 = 1023_u64;

    let tiny = u64::from(x < f64::MIN_POSITIVE);
    let bits = (x * f64::from_bits((BIAS + 54 * tiny) << 52)).to_bits();
    let exponent = bits >> 52;
    let significand = (bits & (ONE - 1)) | ONE;
    let odd = (exponent + 1) & 1;

    let reduced = f64::from_bits((significand - ONE) | ((BIAS + odd) << 52));
    let first = 0.343 * reduced + 0.687;
    let second = 0.5 * (first + reduced / first);
    let third = 0.5 * (second + reduced / second);
    let fourth = 0.5 * (third + reduced / third);
    let near = 0.5 * (fourth + reduced / fourth);

    let root = near.to_bits().wrapping_sub(BIAS << 52).wrapping_add(ONE);
    let square = significand << (52 + odd);
    let rest = square.wrapping_sub(root.wrapping_mul(root));
    let above = rest.wrapping_add(root).wrapping_sub(1);
    let root = root + u64::from(above >= 2 * root) - 2 * (above >> 63);
    let root = f64::from_bits((((exponent + BIAS) >> 1) << 52) + (root - ONE));
    let root = root * f64::from_bits((BIAS - 27 * tiny) << 52);

    let positive = x.to_bits().wrapping_sub(1) < f64::INFINITY.to_bits() - 1;
    let has_root = u64::from(positive).wrapping_neg();
    let other = x.to_bits() | (u64::from(x < 0.0) * f64::NAN.to_bits());
    f64::from_bits((root.to_bits() & has_root) | (other & !has_root))
}
