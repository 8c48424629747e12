//! SIMD numbers by the processor's own instructions.
//!
//! In: lanes, and the proof that the processor has registers for them. Out: [`Register`], a [`Scalar`] whose every
//! operation is one instruction, with the same bits as a [`Pack`].
//!
//! The compiler has to detect that the lanes of a [`Pack`] form a vector. It does so in functions of some hundred
//! operations, sometimes fails in those of a thousand, and takes minutes for those of several thousand.
//!
//! A function that is not inlined is compiled without the instructions and would call each of them. Sections of an
//! inlined function are compiled for the processor by [`Scalar::dispatch`]; other functions get packs.
//! [`Batched::INLINED`](crate::robot::Batched::INLINED) lists the inlined functions of a robot.
#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]

#[cfg(target_arch = "x86")]
use core::arch::x86::{__m128, __m128d, __m256, __m256d, __m512, __m512d};
#[cfg(target_arch = "x86_64")]
use core::arch::x86_64::{__m128, __m128d, __m256, __m256d, __m512, __m512d};
use core::array::from_fn;
use core::fmt::Debug;
use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Range, Sub};
use pulp::bytemuck::{Pod, cast, cast_mut, cast_ref};
use pulp::{NullaryFnOnce, Simd};

use super::packed::{Packed, Packs, spread, together};
use super::processor::{Narrow, Processor, Short, Wide};
use crate::scalar::dispatch::{Work, rounded::Rounded};
use crate::scalar::rounding::{Fused, OfTarget, Rounding};
use crate::scalar::{Lane, Pack, Scalar};

/// A processor whose registers hold several numbers `T`.
pub trait Holds<T>: Copy {
    /// A register. Compilers keep a value of this type in one from the beginning, and an array of numbers in memory.
    type Vector: Pod + Debug;
}

/// `L` numbers `T` in a register of the processor `P`.
#[derive(Clone, Copy, Debug)]
pub struct Register<P: Holds<T>, T: Lane, const L: usize> {
    /// The proof that the processor has the instructions, without size. [`like`](Scalar::like) copies it.
    processor: P,
    vector: P::Vector,
}

impl<P: Holds<T>, T: Lane, const L: usize> Register<P, T, L>
where
    [T; L]: Pod,
{
    #[inline(always)]
    fn lanes(&self) -> &[T; L] {
        cast_ref(&self.vector)
    }

    #[inline(always)]
    fn pack(&self) -> Pack<T, L> {
        Pack(*self.lanes())
    }

    #[inline(always)]
    fn lanes_mut(&mut self) -> &mut [T; L] {
        cast_mut(&mut self.vector)
    }

    #[inline(always)]
    fn of(processor: P, lanes: [T; L]) -> Self {
        let vector = cast(lanes);
        Self { processor, vector }
    }

    /// An infrequent operation, computed by packs.
    #[inline(always)]
    fn as_packs(self, operation: impl FnOnce(Pack<T, L>) -> Pack<T, L>) -> Self {
        Self::of(self.processor, operation(self.pack()).0)
    }
}

/// Angles to be replaced by their sines and cosines.
///
/// They are compiled in a function of their own, because the compiler does not always vectorise them among a thousand
/// other operations. One call for all angles passes them in memory; a call for each angle would pass its lanes one by
/// one.
struct Angles<'a, R, P: Holds<T>, T: Lane, const L: usize> {
    sines: &'a mut [Register<P, T, L>],
    cosines: &'a mut [Register<P, T, L>],
    rounding: PhantomData<R>,
}

impl<R: Rounding, P: Holds<T>, T: Lane, const L: usize> NullaryFnOnce for Angles<'_, R, P, T, L>
where
    [T; L]: Pod,
{
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for (sine, cosine) in self.sines.iter_mut().zip(self.cosines) {
            let processor = sine.processor;
            let ([sines], [cosines]) = Pack::sin_cos_all_by::<R, _>([sine.pack()]);
            *sine = Register::of(processor, sines.0);
            *cosine = Register::of(processor, cosines.0);
        }
    }
}

/// Four numbers of a list, from `first` on.
#[inline(always)]
fn four<T: Copy>(numbers: &[T], first: usize) -> [T; 4] {
    [
        numbers[first],
        numbers[first + 1],
        numbers[first + 2],
        numbers[first + 3],
    ]
}

/// Implements registers of a processor with `$lanes` numbers, and the rounding of functions that choose theirs by the
/// processor.
macro_rules! register {
    ($processor:ident, $number:ident, $lanes:literal, $vector:ident, $rounding:ident, $transposed:ident:
        $unit:ident $set:ident $add:ident $sub:ident $mul:ident $div:ident, $neg:ident $sqrt:ident, $($mul_add:ident)*
    ) => {
        register!(operator $processor, $number, $lanes, $unit: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Holds<$number> for $processor {
            type Vector = $vector;
        }

        impl Neg for Register<$processor, $number, $lanes> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                let Self { processor, vector } = self;
                Self { processor, vector: cast(processor.$neg(cast(vector))) }
            }
        }

        impl Scalar for Register<$processor, $number, $lanes> {
            const IS_PACK: bool = true;

            /// # Panics
            ///
            /// If the processor does not have the instructions. [`like`](Scalar::like) has their proof.
            #[inline]
            fn constant(value: f64) -> Self {
                let processor = $processor::try_new().expect("registers are of the processor that runs");
                Self::filled(processor, $number::constant(value))
            }

            #[inline(always)]
            fn like(self, value: f64) -> Self {
                Self::filled(self.processor, $number::constant(value))
            }

            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                self.mul_add_by::<OfTarget>(factor, term)
            }

            #[inline(always)]
            fn mul_add_by<R: Rounding>(self, factor: Self, term: Self) -> Self {
                if R::FUSES {
                    register!(fused self, factor, term, $($mul_add)*)
                } else {
                    self * factor + term
                }
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                let Self { processor, vector } = self;
                Self { processor, vector: cast(processor.$sqrt(cast(vector))) }
            }

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = self.pack().sin_cos();
                (Self::of(self.processor, sine.0), Self::of(self.processor, cosine.0))
            }

            #[inline(always)]
            fn minus_sine(self, sine: Self) -> Self {
                self.as_packs(|angle| angle.minus_sine(sine.pack()))
            }

            #[inline(always)]
            fn sign(self) -> Self {
                self.as_packs(Pack::sign)
            }

            #[inline(always)]
            fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                Self::sin_cos_all_by::<OfTarget, N>(angles)
            }

            #[inline(always)]
            fn sin_cos_all_by<R: Rounding, const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                let (mut sines, mut cosines) = (angles, angles);
                if let Some(first) = angles.first() {
                    let rounding = PhantomData::<R>;
                    first.processor.vectorize(Angles { sines: &mut sines, cosines: &mut cosines, rounding });
                }
                (sines, cosines)
            }

            #[inline(always)]
            fn dispatch<W: Work<Self>>(work: W) -> W::Output {
                match work.number() {
                    Some(number) => number.processor.vectorize(Rounded::<$rounding, Self, W>::of(work)),
                    None => work.rounded::<$rounding>(),
                }
            }
        }

        impl Packed for Register<$processor, $number, $lanes> {
            type Lane = $number;
            type Number = $number;
            const NUMBERS: usize = 1;

            #[inline]
            fn lane(&self, index: usize) -> $number {
                self.lanes()[index]
            }

            #[inline(always)]
            fn store_list<const N: usize>(list: &[Self; N], results: &mut [[$number; N]]) {
                if N < 4 || $lanes < 4 || results.len() < $lanes {
                    for (lane, result) in results.iter_mut().enumerate() {
                        *result = from_fn(|entry| list[entry].lanes()[lane]);
                    }
                    return;
                }
                let processor = list[0].processor;
                for lane in (0..$lanes).step_by(4) {
                    let mut entry = 0;
                    while entry < N {
                        // If the number of entries is no multiple of four, the last four are moved again.
                        let first = entry.min(N - 4);
                        let of = |entry: usize| four(list[first + entry].lanes(), lane);
                        let [a, b, c, d] = processor.$transposed([of(0), of(1), of(2), of(3)]);
                        results[lane][first..first + 4].copy_from_slice(&a);
                        results[lane + 1][first..first + 4].copy_from_slice(&b);
                        results[lane + 2][first..first + 4].copy_from_slice(&c);
                        results[lane + 3][first..first + 4].copy_from_slice(&d);
                        entry += 4;
                    }
                }
            }

            #[inline(always)]
            fn write(&self, columns: &mut [&mut [$number]], states: Range<usize>) {
                let numbers = &mut columns[0][states];
                if let Some(numbers) = numbers.first_chunk_mut::<$lanes>() {
                    *numbers = *self.lanes();
                } else {
                    let count = numbers.len();
                    numbers.copy_from_slice(&self.lanes()[..count]);
                }
            }
        }

        impl Packs<$number> for Register<$processor, $number, $lanes> {
            const LANES: usize = $lanes;
            type Processor = $processor;

            #[inline(always)]
            fn filled(processor: $processor, number: $number) -> Self {
                Self { processor, vector: processor.$unit.$set(number) }
            }

            #[inline(always)]
            fn gather(processor: $processor, numbers: &[$number]) -> Self {
                Self::of(processor, together(numbers))
            }

            #[inline(always)]
            fn load<const N: usize>(states: &[[$number; N]], packs: &mut [Self; N]) {
                if N < 4 || $lanes < 4 || states.len() < $lanes {
                    spread(states, packs, Self::lanes_mut);
                    return;
                }
                let processor = packs[0].processor;
                for lane in (0..$lanes).step_by(4) {
                    let mut entry = 0;
                    while entry < N {
                        // If the number of entries is no multiple of four, the last four are moved again.
                        let first = entry.min(N - 4);
                        let of = |state: usize| four(&states[lane + state], first);
                        let [a, b, c, d] = processor.$transposed([of(0), of(1), of(2), of(3)]);
                        packs[first].lanes_mut()[lane..lane + 4].copy_from_slice(&a);
                        packs[first + 1].lanes_mut()[lane..lane + 4].copy_from_slice(&b);
                        packs[first + 2].lanes_mut()[lane..lane + 4].copy_from_slice(&c);
                        packs[first + 3].lanes_mut()[lane..lane + 4].copy_from_slice(&d);
                        entry += 4;
                    }
                }
            }
        }
    };
    (fused $self:ident, $factor:ident, $term:ident, $unit:ident $mul_add:ident) => {{
        let Self { processor, vector } = $self;
        Self { processor, vector: processor.$unit.$mul_add(vector, $factor.vector, $term.vector) }
    }};
    // Without the instruction no rounding asks for it.
    (fused $self:ident, $factor:ident, $term:ident,) => { $self * $factor + $term };
    (operator $processor:ident, $number:ident, $lanes:literal, $unit:ident: $($name:ident $method:ident $instruction:ident),*) => {$(
        impl $name for Register<$processor, $number, $lanes> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let Self { processor, vector } = self;
                Self { processor, vector: processor.$unit.$instruction(vector, other.vector) }
            }
        }
    )*};
}

register!(Short, f64, 2, __m128d, OfTarget, transposed_f64:
    sse2 _mm_set1_pd _mm_add_pd _mm_sub_pd _mm_mul_pd _mm_div_pd, neg_f64s sqrt_f64s,);
register!(Short, f32, 4, __m128, OfTarget, transposed_f32:
    sse _mm_set1_ps _mm_add_ps _mm_sub_ps _mm_mul_ps _mm_div_ps, neg_f32s sqrt_f32s,);
register!(Narrow, f64, 4, __m256d, Fused, transposed_f64:
    avx _mm256_set1_pd _mm256_add_pd _mm256_sub_pd _mm256_mul_pd _mm256_div_pd, neg_f64s sqrt_f64s,
    fma _mm256_fmadd_pd);
register!(Narrow, f32, 8, __m256, Fused, transposed_f32:
    avx _mm256_set1_ps _mm256_add_ps _mm256_sub_ps _mm256_mul_ps _mm256_div_ps, neg_f32s sqrt_f32s,
    fma _mm256_fmadd_ps);
register!(Wide, f64, 8, __m512d, Fused, transposed_f64:
    avx512f _mm512_set1_pd _mm512_add_pd _mm512_sub_pd _mm512_mul_pd _mm512_div_pd, neg_f64s sqrt_f64s,
    avx512f _mm512_fmadd_pd);
register!(Wide, f32, 16, __m512, Fused, transposed_f32:
    avx512f _mm512_set1_ps _mm512_add_ps _mm512_sub_ps _mm512_mul_ps _mm512_div_ps, neg_f32s sqrt_f32s,
    avx512f _mm512_fmadd_ps);
