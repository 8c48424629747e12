//! Transposition by vector instructions.

use pulp::bytemuck::cast;
use pulp::x86::V3;

/// Transposes four rows of four numbers.
#[inline(always)]
pub fn turned(processor: &V3, [a, b, c, d]: [[f32; 4]; 4]) -> [[f32; 4]; 4] {
    let sse = processor.sse;
    let (a, b, c, d) = (cast(a), cast(b), cast(c), cast(d));
    let (first_ab, last_ab) = (sse._mm_unpacklo_ps(a, b), sse._mm_unpackhi_ps(a, b));
    let (first_cd, last_cd) = (sse._mm_unpacklo_ps(c, d), sse._mm_unpackhi_ps(c, d));
    [
        cast(sse._mm_movelh_ps(first_ab, first_cd)),
        cast(sse._mm_movehl_ps(first_cd, first_ab)),
        cast(sse._mm_movelh_ps(last_ab, last_cd)),
        cast(sse._mm_movehl_ps(last_cd, last_ab)),
    ]
}
