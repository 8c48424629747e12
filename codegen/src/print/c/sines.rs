//! Sine and cosine of a C file.
//!
//! In: the scalar type and options. Out: a private function from the [`statements`] that all languages share, with the
//! last step by bits.

use super::COptions;
use super::body::CWriter;
use super::declarations::number;
use crate::print::sines::{ANGLE, COSINE, SHIFTED, SINE, range, statements};
use crate::print::walk::walk;
use crate::real::Real;

/// The function and the struct that it returns.
pub(super) fn function(real: Real, options: &COptions<'_>) -> String {
    let mut writer = CWriter::new(real, options);
    walk(&mut writer, &statements(real));
    let [turn, sin_cos] = ["turn", "sin_cos"].map(|name| options.own(name));
    let number = number(real);
    let (width, top) = match real {
        Real::F32 => (32, "0x80000000u"),
        Real::F64 | Real::Generic => (64, "0x8000000000000000u"),
    };
    let range = range(real);
    let (limit, turns, error) = (range.limit, range.turns, range.error);
    let (growth, end) = (range.growth, range.end);
    let places = width - 2;
    format!(
        "/* Sine and cosine of an angle. */
typedef struct {{
    {number} sine;
    {number} cosine;
}} {turn};

/* Sine and cosine of an angle up to {limit} rad ({turns} turns), within {error} units in the last place.
 *
 * No branches, so that every angle takes the same time. Beyond {limit} rad the error grows as
 * {growth} |angle|, from {end} rad on results are meaningless and may be infinite or NaN; NaN and
 * infinite angles give NaN. Cody-Waite reduction to |r| <= pi/4, then minimax polynomials.
 * The sum `{SHIFTED}` has no bits for a fraction: its low bits hold the rounded integer.
 */
static HOMOGEN_FN {turn} {sin_cos}({number} {ANGLE})
{{
{statements}
    /* In odd quadrants sine and cosine are exchanged, by bits. */
    union {{
        {number} number;
        uint{width}_t bits;
    }} s, c, n;
    {turn} turn;
    uint{width}_t exchanged;
    n.number = {SHIFTED};
    s.number = {SINE};
    c.number = {COSINE};
    exchanged = (s.bits ^ c.bits) & (0u - (n.bits & 1u));
    s.bits ^= exchanged ^ ((n.bits << {places}) & {top});
    c.bits ^= exchanged ^ (((n.bits + 1u) << {places}) & {top});
    turn.sine = s.number;
    turn.cosine = c.number;
    return turn;
}}
",
        statements = writer.text
    )
}
