//! Square root of a C file, so that it needs no library.
//!
//! In: the scalar type and options. Out: a private function with the steps of that in Rust for `core` alone, whose
//! results have the same bits as the processor's instruction.

use super::COptions;
use super::declarations::number;
use crate::real::Real;

/// Name of the function after the prefix.
pub(super) const SQRT: &str = "sqrt";

/// The function.
pub(super) fn function(real: Real, options: &COptions<'_>) -> String {
    let (name, number) = (options.own(SQRT), number(real));
    let is_single = real == Real::F32;
    let (width, places, bias) = if is_single {
        (32, 23, 127)
    } else {
        (64, 52, 1023)
    };
    let least = if is_single { "FLT_MIN" } else { "DBL_MIN" };
    let letter = if is_single { "f" } else { "" };
    let (up, iterations) = if is_single { (24, 3) } else { (54, 4) };
    let (down, top) = (up / 2, width - 1);
    let nearer = format!("    near = 0.5{letter} * (near + n.number / near);\n").repeat(iterations);
    format!(
        "/* The square root, correctly rounded; NaN of negative numbers.
 *
 * No branches. An iteration gives an estimate within one unit in the last place; the remainder, exact in
 * integers, decides the rounding. Zeros, infinity and NaN are selected by bits.
 */
static HOMOGEN_FN {number} {name}({number} x)
{{
    const uint{width}_t one = (uint{width}_t)1 << {places};
    const uint{width}_t bias = {bias}u;
    const uint{width}_t infinity = (2u * bias + 1u) << {places};
    union {{
        {number} number;
        uint{width}_t bits;
    }} n, m, unit;
    {number} near;
    uint{width}_t tiny, exponent, significand, odd, root, above, has_root;
    tiny = x < {least} ? 1u : 0u;
    unit.bits = (bias + {up}u * tiny) << {places};
    n.number = x * unit.number;
    exponent = n.bits >> {places};
    significand = (n.bits & (one - 1u)) | one;
    odd = (exponent + 1u) & 1u;
    n.bits = (significand - one) | ((bias + odd) << {places});
    near = 0.343{letter} * n.number + 0.687{letter};
{nearer}    n.number = near;
    root = n.bits - (bias << {places}) + one;
    above = (significand << ({places}u + odd)) - root * root + root - 1u;
    root = root + (above >= 2u * root ? 1u : 0u) - 2u * (above >> {top});
    n.bits = (((exponent + bias) >> 1) << {places}) + (root - one);
    unit.bits = (bias - {down}u * tiny) << {places};
    n.number = n.number * unit.number;
    m.number = x;
    has_root = m.bits - 1u < infinity - 1u ? ~(uint{width}_t)0 : 0u;
    m.bits |= x < 0.0{letter} ? infinity | (one >> 1) : 0u;
    n.bits = (n.bits & has_root) | (m.bits & ~has_root);
    return n.number;
}}
"
    )
}
