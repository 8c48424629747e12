//! Proofs that the processor has registers of a length, as types without size; transposition of 4×4 blocks.
//!
//! In: the features of the target, and those that are found at run time. Out: a value of a type, the proof, for each
//! length of registers.
#![cfg_attr(
    any(target_arch = "x86", target_arch = "x86_64"),
    expect(
        clippy::inline_always,
        reason = "only what is inlined is compiled for the processor that was found"
    )
)]

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
pub use {pulp::x86::V2 as Short, pulp::x86::V3 as Narrow, pulp::x86::V4 as Wide};

/// No proof is needed: only the target's instructions are used.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
pub type Short = ();

/// No proof is needed: only the target's instructions are used.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
pub type Narrow = ();

/// No proof is needed: only the target's instructions are used.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
pub type Wide = ();

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
pub(super) use x86::Processor;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod x86 {
    use core::array::from_fn;
    use pulp::bytemuck::cast;
    use pulp::core_arch::x86::{Avx, Sse};

    use super::{Narrow, Short, Wide};

    /// The proof that the processor has registers of a length, with its transpositions.
    pub trait Processor: Copy {
        /// The transposed block of four rows.
        fn transposed_f64(self, rows: [[f64; 4]; 4]) -> [[f64; 4]; 4];

        /// The same in single precision.
        fn transposed_f32(self, rows: [[f32; 4]; 4]) -> [[f32; 4]; 4];
    }

    macro_rules! processors {
        ($($processor:ident: $transposed_f64:expr;)*) => {$(
            impl Processor for $processor {
                #[inline(always)]
                fn transposed_f64(self, rows: [[f64; 4]; 4]) -> [[f64; 4]; 4] {
                    $transposed_f64(self, rows)
                }

                #[inline(always)]
                fn transposed_f32(self, rows: [[f32; 4]; 4]) -> [[f32; 4]; 4] {
                    by_sse(self.sse, rows)
                }
            }
        )*};
    }
    processors! {
        Short: |_, rows: [[f64; 4]; 4]| from_fn(|entry| rows.map(|row| row[entry]));
        Narrow: |processor: Self, rows| by_avx(processor.avx, rows);
        Wide: |processor: Self, rows| by_avx(processor.avx, rows);
    }

    #[inline(always)]
    fn by_avx(avx: Avx, rows: [[f64; 4]; 4]) -> [[f64; 4]; 4] {
        let [a, b, c, d] = rows;
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

    #[inline(always)]
    fn by_sse(sse: Sse, rows: [[f32; 4]; 4]) -> [[f32; 4]; 4] {
        let [a, b, c, d] = rows;
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
}
