//! Conversion of states into packs, and of packs into results.
//!
//! In: states as arrays, and results whose every number is a pack. Out: arrays of packs, and the result of
//! one lane; the types of packs for each type of number.
#![expect(
    clippy::inline_always,
    reason = "what fills the lanes is to be compiled for the processor that was found"
)]

use super::processor;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use super::registers::Register;
use crate::matrix::{Acceleration, Action, Momentum, Point, Pose, Screw, Velocity};
use crate::robot::derivatives::{
    AccelerationChange, AccelerationDerivatives, AccelerationGradient, AccelerationHessian,
    TorqueChange, TorqueDerivatives, TorqueGradient, TorqueHessian,
};
use crate::scalar::{Lane, Pack, Scalar};
use core::array::{from_fn, from_mut};
use core::ops::Range;

/// A number of batches, `f32` or `f64`, with its packs.
pub trait Number: Lane {
    /// Lanes for registers of up to 256 bits.
    type Narrow: Packs<Self, Processor = ()>;
    /// Lanes for registers of 512 bits.
    type Wide: Packs<Self, Processor = ()>;
    /// Lanes for any processor.
    type Plain: Packs<Self, Processor = ()>;
    /// Lanes in a register of 128 bits.
    type InShort: Packs<Self, Processor = processor::Short>;
    /// The lanes of [`Narrow`](Self::Narrow) in a register.
    type InNarrow: Packs<Self, Processor = processor::Narrow>;
    /// The lanes of [`Wide`](Self::Wide) in a register.
    type InWide: Packs<Self, Processor = processor::Wide>;
}

/// The lanes of a pack in a register of a processor; on other architectures than x86 the pack itself.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
macro_rules! held {
    ($processor:ident, $number:ty, $lanes:literal) => {
        Register<processor::$processor, $number, $lanes>
    };
}
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
macro_rules! held {
    ($processor:ident, $number:ty, $lanes:literal) => {
        Pack<$number, $lanes>
    };
}

macro_rules! number {
    ($float:ident: $short:literal, $narrow:literal, $wide:literal) => {
        impl Number for $float {
            type Narrow = Pack<$float, $narrow>;
            type Wide = Pack<$float, $wide>;
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            type Plain = $float;
            #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
            type Plain = Self::Narrow;
            type InShort = held!(Short, $float, $short);
            type InNarrow = held!(Narrow, $float, $narrow);
            type InWide = held!(Wide, $float, $wide);
        }
    };
}
number!(f64: 2, 4, 8);
number!(f32: 4, 8, 16);

/// A pack of numbers `T`, with any number of lanes.
pub trait Packs<T>: Scalar + Packed<Lane = T, Number = T> {
    /// Number of lanes.
    const LANES: usize;

    /// The proof that the processor has the instructions of the pack.
    type Processor: Copy;

    /// The same number in each lane.
    fn filled(processor: Self::Processor, number: T) -> Self;

    /// One number a lane; the last number fills lanes without a state.
    fn gather(processor: Self::Processor, numbers: &[T]) -> Self;

    /// One state a lane, one pack for each entry; the last state fills lanes without a state.
    fn load<const N: usize>(states: &[[T; N]], packs: &mut [Self; N]);
}

impl<T: Lane, const L: usize> Packs<T> for Pack<T, L> {
    const LANES: usize = L;
    type Processor = ();

    #[inline(always)]
    fn filled((): (), number: T) -> Self {
        Self([number; L])
    }

    #[inline(always)]
    fn gather((): (), numbers: &[T]) -> Self {
        Self(together(numbers))
    }

    #[inline(always)]
    fn load<const N: usize>(states: &[[T; N]], packs: &mut [Self; N]) {
        spread(states, packs, |pack| &mut pack.0);
    }
}

/// A number alone, where there are no registers for several.
impl<T: Lane> Packs<T> for T {
    const LANES: usize = 1;
    type Processor = ();

    #[inline(always)]
    fn filled((): (), number: T) -> Self {
        number
    }

    #[inline(always)]
    fn gather((): (), numbers: &[T]) -> Self {
        let [number] = together(numbers);
        number
    }

    #[inline(always)]
    fn load<const N: usize>(states: &[[T; N]], packs: &mut [Self; N]) {
        spread(states, packs, from_mut);
    }
}

/// The lanes of a pack from a number of each state; the last number fills lanes without a state.
#[inline(always)]
pub(super) fn together<T: Copy + Default, const L: usize>(numbers: &[T]) -> [T; L] {
    if let Some(numbers) = numbers.first_chunk::<L>() {
        return *numbers;
    }
    let (states, _) = numbers.as_chunks::<1>();
    filled_up(states).map(|[number]| number)
}

/// Fills packs, one for each entry, with one state a lane; the last state fills lanes without a state.
#[inline(always)]
pub(super) fn spread<T: Copy + Default, P, const L: usize, const N: usize>(
    states: &[[T; N]],
    packs: &mut [P; N],
    lanes: impl Fn(&mut P) -> &mut [T; L],
) {
    let padded;
    let states = if let Some(states) = states.first_chunk::<L>() {
        states
    } else {
        padded = filled_up(states);
        &padded
    };
    for (i, pack) in packs.iter_mut().enumerate() {
        for (lane, state) in lanes(pack).iter_mut().zip(states) {
            *lane = state[i];
        }
    }
}

/// `L` states: the given ones, then copies of the last.
#[cold]
#[inline(never)]
fn filled_up<T: Copy + Default, const N: usize, const L: usize>(states: &[[T; N]]) -> [[T; N]; L] {
    let last = states.last().copied().unwrap_or([T::default(); N]);
    from_fn(|lane| states.get(lane).copied().unwrap_or(last))
}

/// A result made of packs: the results of as many states as there are lanes.
pub trait Packed {
    /// The result of one state.
    type Lane;

    /// The type of its numbers.
    type Number;

    /// Number of numbers in the result of one state.
    const NUMBERS: usize;

    /// The result of the state in lane `index`.
    ///
    /// # Panics
    ///
    /// If there is no lane `index`.
    #[must_use]
    fn lane(&self, index: usize) -> Self::Lane;

    /// Writes the results of the first lanes to these states.
    ///
    /// # Panics
    ///
    /// If there are fewer lanes than results.
    #[inline(always)]
    fn store(&self, results: &mut [Self::Lane])
    where
        Self: Sized,
    {
        lane_by_lane(self, results);
    }

    /// The same for an array of results.
    ///
    /// # Panics
    ///
    /// If there are fewer lanes than results.
    #[inline(always)]
    fn store_list<const N: usize>(list: &[Self; N], results: &mut [[Self::Lane; N]])
    where
        Self: Sized,
    {
        lane_by_lane(list, results);
    }

    /// Writes its numbers to columns, one column for each number: the first lanes to the range `states`.
    ///
    /// # Panics
    ///
    /// If there are fewer than [`NUMBERS`](Self::NUMBERS) columns, or a column has fewer states, or a register fewer
    /// lanes, than `states`.
    fn write(&self, columns: &mut [&mut [Self::Number]], states: Range<usize>);
}

/// Writes the result of each lane.
///
/// Never inlined: the vectors of a result must be stored as they are, because the compiler detects vectors by
/// their stores.
#[inline(never)]
fn lane_by_lane<P: Packed>(packed: &P, results: &mut [P::Lane]) {
    for (lane, result) in results.iter_mut().enumerate() {
        *result = packed.lane(lane);
    }
}

impl<T: Lane, const L: usize> Packed for Pack<T, L> {
    type Lane = T;
    type Number = T;
    const NUMBERS: usize = 1;

    #[inline]
    fn lane(&self, index: usize) -> T {
        self.0[index]
    }

    #[inline(always)]
    fn write(&self, columns: &mut [&mut [T]], states: Range<usize>) {
        let numbers = &mut columns[0][states];
        if let Some(numbers) = numbers.first_chunk_mut::<L>() {
            *numbers = self.0;
        } else {
            let count = numbers.len();
            numbers.copy_from_slice(&self.0[..count]);
        }
    }
}

impl<T: Lane> Packed for T {
    type Lane = T;
    type Number = T;
    const NUMBERS: usize = 1;

    #[inline]
    fn lane(&self, _: usize) -> T {
        *self
    }

    #[inline(always)]
    fn write(&self, columns: &mut [&mut [T]], states: Range<usize>) {
        columns[0][states].fill(*self);
    }
}

impl<P: Packed, const N: usize> Packed for [P; N] {
    type Lane = [P::Lane; N];
    type Number = P::Number;
    const NUMBERS: usize = N * P::NUMBERS;

    #[inline]
    fn lane(&self, index: usize) -> Self::Lane {
        from_fn(|i| self[i].lane(index))
    }

    #[inline(always)]
    fn store(&self, results: &mut [Self::Lane]) {
        P::store_list(self, results);
    }

    #[inline(always)]
    fn write(&self, columns: &mut [&mut [P::Number]], states: Range<usize>) {
        for (i, part) in self.iter().enumerate() {
            part.write(&mut columns[i * P::NUMBERS..], states.clone());
        }
    }
}

/// Implements [`Packed`] for a typed matrix by its blocks, with the number of numbers in each.
macro_rules! of_parts {
    ($($kind:ident: $($part:ident $numbers:literal),*;)*) => {$(
        impl<P: Packed + Scalar> Packed for $kind<P> {
            type Lane = $kind<P::Lane>;
            type Number = P::Number;
            const NUMBERS: usize = P::NUMBERS * (0 $(+ $numbers)*);

            #[inline]
            fn lane(&self, index: usize) -> Self::Lane {
                $kind::new($(self.$part().lane(index)),*)
            }

            #[inline(always)]
            fn write(&self, columns: &mut [&mut [P::Number]], states: Range<usize>) {
                let rest = columns;
                $(
                    let (own, rest) = rest.split_at_mut(P::NUMBERS * $numbers);
                    self.$part().write(own, states.clone());
                )*
                let _ = rest;
            }
        }
    )*};
}
of_parts! {
    Pose: rotation 9, translation 3;
    Screw: u 3, b 3;
    Velocity: omega 3, v 3;
    Acceleration: g 9, a 3;
    Momentum: gamma 3, rho 3;
    Action: c 3, f 3;
}

impl<P: Packed> Packed for Point<P> {
    type Lane = Point<P::Lane>;
    type Number = P::Number;
    const NUMBERS: usize = 3 * P::NUMBERS;

    #[inline]
    fn lane(&self, index: usize) -> Self::Lane {
        Point(self.0.lane(index))
    }

    #[inline(always)]
    fn write(&self, columns: &mut [&mut [P::Number]], states: Range<usize>) {
        self.0.write(columns, states);
    }
}

/// Implements [`Packed`] for a struct of vectors or matrices over N.
macro_rules! of_fields {
    ($($kind:ident of $part:ty: $($field:ident),*;)*) => {$(
        impl<P: Packed, const N: usize> Packed for $kind<N, P> {
            type Lane = $kind<N, P::Lane>;
            type Number = P::Number;
            const NUMBERS: usize = [$(stringify!($field)),*].len() * <$part>::NUMBERS;

            #[inline]
            fn lane(&self, index: usize) -> Self::Lane {
                $kind { $($field: self.$field.lane(index)),* }
            }

            #[inline(always)]
            fn write(&self, columns: &mut [&mut [P::Number]], states: Range<usize>) {
                let rest = columns;
                $(
                    let (own, rest) = rest.split_at_mut(<$part>::NUMBERS);
                    self.$field.write(own, states.clone());
                )*
                let _ = rest;
            }
        }
    )*};
}
of_fields! {
    TorqueChange of [P; N]: value, change;
    TorqueGradient of [P; N]: dq, dqd, dqdd;
    TorqueDerivatives of [[P; N]; N]: dq, dqd;
    TorqueHessian of [[P; N]; N]: dq_dq, dq_dqd, dqd_dqd, dq_dqdd;
    AccelerationChange of [P; N]: value, change;
    AccelerationGradient of [P; N]: dq, dqd, dtau;
    AccelerationDerivatives of [[P; N]; N]: dq, dqd, dtau;
    AccelerationHessian of [[P; N]; N]: dq_dq, dq_dqd, dqd_dqd, dq_dtau;
}
