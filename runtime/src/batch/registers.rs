//! Lanes in a register, by the processor's own instructions.
//!
//! In: lanes, and the proof that the processor has AVX2 or AVX-512. Out: [`Register`], a [`Scalar`] each of whose
//! operations is one instruction from the start. Of a [`Pack`] the compiler has to find out that its lanes
//! belong together: it does so in functions of some hundred operations, gives up by chance in those of a
//! thousand, and takes minutes for those of several thousand. Every lane has the bits that a pack's has.
//! What stayed a call would be compiled without the instructions, and would call each of them instead; which
//! functions of a robot do not is told by their traits.
#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]

use core::ops::{Add, Div, Mul, Neg, Range, Sub};
use pulp::bytemuck::cast;
use pulp::x86::{V3, V4};
use pulp::{Simd, WithSimd};

use super::packed::{Packed, Packs, spread, together};
use crate::scalar::{Fused, Lane, Pack, Scalar};

/// `L` numbers `T` in a register of the processor `S`.
#[derive(Clone, Copy, Debug)]
pub struct Register<S, T: Lane, const L: usize> {
    /// The proof that the processor has the instructions. It takes no room.
    processor: S,
    lanes: [T::Bare; L],
}

impl<S: Copy, T: Lane, const L: usize> Register<S, T, L> {
    #[inline(always)]
    fn pack(self) -> Pack<T, L> {
        Pack(self.lanes.map(T::of))
    }

    #[inline(always)]
    fn of(processor: S, pack: Pack<T, L>) -> Self {
        Self {
            processor,
            lanes: pack.0.map(T::bare),
        }
    }

    /// What is rarely wanted, and is computed as packs do.
    #[inline(always)]
    fn as_packs(self, operation: impl FnOnce(Pack<T, L>) -> Pack<T, L>) -> Self {
        Self::of(self.processor, operation(self.pack()))
    }
}

/// Sines and cosines of packs, to be compiled by themselves: among a thousand other operations the compiler does
/// not always see that their lanes belong together.
struct Sines<T, const L: usize, const N: usize>([Pack<T, L>; N]);

impl<T: Lane, const L: usize, const N: usize> WithSimd for Sines<T, L, N> {
    type Output = ([Pack<T, L>; N], [Pack<T, L>; N]);

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) -> Self::Output {
        Pack::sin_cos_all(self.0)
    }
}

/// Registers of a processor that hold so many numbers; `fuses` says whether a product and a sum are one instruction.
macro_rules! register {
    ($processor:ident, $number:ty, $lanes:literal, fuses: $fuses:expr, $bare:ident:
        $add:ident $sub:ident $mul:ident $div:ident $mul_add:ident $neg:ident $sqrt:ident
    ) => {
        register!(operator $processor, $number, $lanes: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Neg for Register<$processor, $number, $lanes> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                let Self { processor, lanes } = self;
                Self { processor, lanes: cast(processor.$neg(cast(lanes))) }
            }
        }

        impl Scalar for Register<$processor, $number, $lanes> {
            /// # Panics
            ///
            /// Where the processor has not the instructions: only [`like`](Scalar::like) has the proof.
            #[inline]
            fn constant(value: f64) -> Self {
                let processor = $processor::try_new().expect("registers are of the processor that runs");
                Self { processor, lanes: [$bare::constant(value); $lanes] }
            }

            #[inline(always)]
            fn like(self, value: f64) -> Self {
                Self { lanes: [$bare::constant(value); $lanes], ..self }
            }

            #[inline(always)]
            fn mul_add(self, factor: Self, term: Self) -> Self {
                if $fuses {
                    let Self { processor, lanes } = self;
                    let lanes = processor.$mul_add(cast(lanes), cast(factor.lanes), cast(term.lanes));
                    Self { processor, lanes: cast(lanes) }
                } else {
                    self * factor + term
                }
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                let Self { processor, lanes } = self;
                Self { processor, lanes: cast(processor.$sqrt(cast(lanes))) }
            }

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = self.pack().sin_cos();
                (Self::of(self.processor, sine), Self::of(self.processor, cosine))
            }

            #[inline(always)]
            fn less_sine(self, sine: Self) -> Self {
                self.as_packs(|angle| angle.less_sine(sine.pack()))
            }

            #[inline(always)]
            fn sign(self) -> Self {
                self.as_packs(Pack::sign)
            }

            #[inline(always)]
            fn sgn(self) -> Self {
                self.as_packs(Pack::sgn)
            }

            #[inline(always)]
            fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                let Some(&Self { processor, .. }) = angles.first() else {
                    return (angles, angles);
                };
                let (sines, cosines) = Simd::vectorize(processor, Sines(angles.map(Self::pack)));
                let held = |pack| Self::of(processor, pack);
                (sines.map(held), cosines.map(held))
            }
        }

        impl Packs<$bare> for Register<$processor, $number, $lanes> {
            const LANES: usize = $lanes;
            type Processor = $processor;
            type Loose = Pack<$number, $lanes>;

            #[inline(always)]
            fn filled(processor: $processor, number: $bare) -> Self {
                Self { processor, lanes: [number; $lanes] }
            }

            #[inline(always)]
            fn gather(processor: $processor, numbers: &[$bare]) -> Self {
                Self { processor, lanes: together(numbers, |number| number) }
            }

            #[inline(always)]
            fn load<const N: usize>(states: &[[$bare; N]], packs: &mut [Self; N]) {
                spread(states, packs, |pack| &mut pack.lanes, |number| number);
            }
        }
    };
    (operator $processor:ident, $number:ty, $lanes:literal: $($name:ident $method:ident $instruction:ident),*) => {$(
        impl $name for Register<$processor, $number, $lanes> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let Self { processor, lanes } = self;
                Self { processor, lanes: cast(processor.$instruction(cast(lanes), cast(other.lanes))) }
            }
        }
    )*};
}

/// Registers of both kinds of numbers: such that round as the number alone does, and such that fuse.
macro_rules! registers {
    ($processor:ident: $double:literal $single:literal) => {
        registers!($processor, f64, $double:
            add_f64s sub_f64s mul_f64s div_f64s mul_add_f64s neg_f64s sqrt_f64s);
        registers!($processor, f32, $single:
            add_f32s sub_f32s mul_f32s div_f32s mul_add_f32s neg_f32s sqrt_f32s);
    };
    ($processor:ident, $float:ident, $lanes:literal: $($instruction:ident)*) => {
        register!($processor, $float, $lanes, fuses: cfg!(target_feature = "fma"), $float: $($instruction)*);
        register!($processor, Fused<$float>, $lanes, fuses: true, $float: $($instruction)*);
    };
}
registers!(V3: 4 8);
registers!(V4: 8 16);

impl<S, T: Lane, const L: usize> Packed for Register<S, T, L> {
    type Lane = T::Bare;
    type Number = T::Bare;
    const NUMBERS: usize = 1;

    #[inline]
    fn lane(&self, index: usize) -> T::Bare {
        self.lanes[index]
    }

    #[inline(always)]
    fn write(&self, columns: &mut [&mut [T::Bare]], states: Range<usize>) {
        let numbers = &mut columns[0][states];
        if let Some(numbers) = numbers.first_chunk_mut::<L>() {
            *numbers = self.lanes;
        } else {
            let count = numbers.len();
            numbers.copy_from_slice(&self.lanes[..count]);
        }
    }
}
