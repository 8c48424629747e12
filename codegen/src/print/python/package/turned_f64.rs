//! Transposition by vector instructions.

use pulp::bytemuck::cast;
use pulp::x86::V3;

/// Transposes four rows of four numbers.
#[inline(always)]
pub fn turned(processor: &V3, [a, b, c, d]: [[f64; 4]; 4]) -> [[f64; 4]; 4] {
    let avx = processor.avx;
    let (a, b, c, d) = (cast(a), cast(b), cast(c), cast(d));
    let (even_ab, odd_ab) = (avx._mm256_unpacklo_pd(a, b), avx._mm256_unpackhi_pd(a, b));
    let (even_cd, odd_cd) = (avx._mm256_unpacklo_pd(c, d), avx._mm256_unpackhi_pd(c, d));
    [
        cast(avx._mm256_permute2f128_pd::<0x20>(even_ab, even_cd)),
        cast(avx._mm256_permute2f128_pd::<0x20>(odd_ab, odd_cd)),
        cast(avx._mm256_permute2f128_pd::<0x31>(even_ab, even_cd)),
        cast(avx._mm256_permute2f128_pd::<0x31>(odd_ab, odd_cd)),
    ]
}
