//! States into packs, and results out of them.
//!
//! In: states as arrays, and results whose every number is a pack. Out: arrays of packs, and the result of
//! one lane. Which packs a type of number goes into is said here; it never computes anything.
#![expect(
    clippy::inline_always,
    reason = "what fills the lanes is to be compiled for the processor that was found"
)]

use crate::matrix::{Acceleration, Action, Momentum, Point, Pose, Screw, Velocity};
use crate::robot::derivatives::{ForwardDynamicsDerivatives, InverseDynamicsDerivatives};
use crate::scalar::{Fused, Lane, Pack, Scalar};
use core::array::from_fn;

/// A number that batches are made of, `f32` or `f64`, and the packs that it goes into.
pub trait Number: Lane<Bare = Self> {
    /// Lanes for registers of up to 256 bits, which compute as the number alone does.
    type Narrow: Packs<Self>;
    /// Lanes for registers of 512 bits, which compute as the number alone does.
    type Wide: Packs<Self>;
    /// Lanes for registers of 256 bits, which fuse products with sums.
    type FusedNarrow: Packs<Self>;
    /// Lanes for registers of 512 bits, which fuse products with sums.
    type FusedWide: Packs<Self>;
}

macro_rules! number {
    ($float:ident: $narrow:literal, $wide:literal) => {
        impl Number for $float {
            type Narrow = Pack<$float, $narrow>;
            type Wide = Pack<$float, $wide>;
            type FusedNarrow = Pack<Fused<$float>, $narrow>;
            type FusedWide = Pack<Fused<$float>, $wide>;
        }
    };
}
number!(f64: 4, 8);
number!(f32: 8, 16);

/// Which packs a batch goes into: how its products and sums are rounded.
pub trait Rounding: Send + sealed::Sealed {
    /// Lanes for registers of up to 256 bits.
    type Narrow<T: Number>: Packs<T>;
    /// Lanes for registers of 512 bits.
    type Wide<T: Number>: Packs<T>;
}

/// As the function of one state is rounded.
#[derive(Clone, Copy, Debug)]
pub enum AsAlone {}

/// Fused wherever the processor that runs has the instruction.
#[derive(Clone, Copy, Debug)]
pub enum AsFused {}

impl Rounding for AsAlone {
    type Narrow<T: Number> = T::Narrow;
    type Wide<T: Number> = T::Wide;
}

impl Rounding for AsFused {
    type Narrow<T: Number> = T::FusedNarrow;
    type Wide<T: Number> = T::FusedWide;
}

mod sealed {
    /// What only this crate implements.
    pub trait Sealed {}
    impl Sealed for super::AsAlone {}
    impl Sealed for super::AsFused {}
}

/// A pack of a type of number, whatever the count of its lanes.
pub trait Packs<T>: Scalar + Packed<Lane = T> {
    /// How many lanes it has.
    const LANES: usize;

    /// One state a lane; where states are fewer than lanes the others get the last one.
    fn load<const N: usize>(states: &[[T; N]], packs: &mut [Self; N]);
}

impl<T: Lane, const L: usize> Packs<T::Bare> for Pack<T, L> {
    const LANES: usize = L;

    #[inline(always)]
    fn load<const N: usize>(states: &[[T::Bare; N]], packs: &mut [Self; N]) {
        let padded;
        let states = if let Some(states) = states.first_chunk::<L>() {
            states
        } else {
            padded = filled_up(states);
            &padded
        };
        for (i, pack) in packs.iter_mut().enumerate() {
            for (lane, state) in pack.0.iter_mut().zip(states) {
                *lane = T::of(state[i]);
            }
        }
    }
}

/// Some states, and the last one again in the place of those that are missing.
#[cold]
#[inline(never)]
fn filled_up<T: Copy + Default, const N: usize, const L: usize>(states: &[[T; N]]) -> [[T; N]; L] {
    let last = states.last().copied().unwrap_or([T::default(); N]);
    from_fn(|lane| states.get(lane).copied().unwrap_or(last))
}

/// What is made of packs: the result of as many states as they have lanes.
pub trait Packed {
    /// The result of one state.
    type Lane;

    /// The result of the state in lane `index`, which must be one.
    #[must_use]
    fn lane(&self, index: usize) -> Self::Lane;
}

impl<T: Lane, const L: usize> Packed for Pack<T, L> {
    type Lane = T::Bare;

    #[inline]
    fn lane(&self, index: usize) -> T::Bare {
        self.0[index].bare()
    }
}

impl<P: Packed, const N: usize> Packed for [P; N] {
    type Lane = [P::Lane; N];

    #[inline]
    fn lane(&self, index: usize) -> Self::Lane {
        from_fn(|i| self[i].lane(index))
    }
}

/// The lane of a matrix by those of its parts.
macro_rules! of_parts {
    ($($kind:ident: $($part:ident),*;)*) => {$(
        impl<P: Packed + Scalar> Packed for $kind<P> {
            type Lane = $kind<P::Lane>;

            #[inline]
            fn lane(&self, index: usize) -> Self::Lane {
                $kind::new($(self.$part().lane(index)),*)
            }
        }
    )*};
}
of_parts! {
    Pose: rotation, translation;
    Screw: u, b;
    Velocity: omega, v;
    Acceleration: g, a;
    Momentum: gamma, rho;
    Action: c, f;
}

impl<P: Packed> Packed for Point<P> {
    type Lane = Point<P::Lane>;

    #[inline]
    fn lane(&self, index: usize) -> Self::Lane {
        Point(self.0.lane(index))
    }
}

/// The lane of a structure by those of its fields.
macro_rules! of_fields {
    ($($kind:ident: $($field:ident),*;)*) => {$(
        impl<P: Packed, const N: usize> Packed for $kind<N, P> {
            type Lane = $kind<N, P::Lane>;

            #[inline]
            fn lane(&self, index: usize) -> Self::Lane {
                $kind { $($field: self.$field.lane(index)),* }
            }
        }
    )*};
}
of_fields! {
    InverseDynamicsDerivatives: dq, dqd;
    ForwardDynamicsDerivatives: dq, dqd, dtau;
}
