//! Dispatch of a batch: the widest registers of the processor and, with the feature `rayon`, all its cores.
//!
//! In: [`Work`] on states, which can be split. Out: the results that the work writes.
#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]

use super::packed::Packs;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use super::processor::{Narrow, Short, Wide};

/// Work on states, by packs or registers of any length.
pub(super) trait Work: Sized + Send {
    /// The number of states.
    #[cfg(feature = "rayon")]
    fn states(&self) -> usize;

    /// The work on the states before and from `at`.
    #[cfg(feature = "rayon")]
    fn split(self, at: usize) -> (Self, Self);

    /// Computes in packs, for any processor.
    fn plain(self);

    /// Computes in registers of 128 bits.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn short(self, processor: Short);

    /// Computes in registers of 256 bits.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn narrow(self, processor: Narrow);

    /// Computes in registers of 512 bits.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn wide(self, processor: Wide);
}

/// Methods of [`Work`] for a type with a method `by`, generic over packs, and a robot `R`; `T` is the type of the
/// numbers.
macro_rules! by_packs {
    ($method:ident) => {
        #[inline(always)]
        fn plain(self) {
            self.by::<T::Plain>(());
        }

        run::by_packs!(@ $method short Short T::InShort, T::Narrow);
        run::by_packs!(@ $method narrow Narrow T::InNarrow, T::Narrow);
        run::by_packs!(@ $method wide Wide T::InWide, T::Wide);
    };
    // Registers if the function is inlined and so compiled for the processor, otherwise packs.
    (@ $function:ident $method:ident $processor:ident $packs:ty, $loose:ty) => {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        #[inline(always)]
        fn $method(self, processor: processor::$processor) {
            if const { robot::is_inlined::<R>(stringify!($function)) } {
                self.by::<$packs>(processor);
            } else {
                self.by::<$loose>(());
            }
        }
    };
}
pub(super) use by_packs;

/// The longest registers that a batch may use, if the processor has them. No result depends on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Vectors {
    /// Up to 256 bits: AVX2 with FMA, or SSE4.2 where the processor does not have these.
    Bits256,
    /// Up to 512 bits: AVX-512.
    #[default]
    Bits512,
}

/// Does the work in the registers of this processor.
#[cfg(not(feature = "rayon"))]
pub(super) fn run<W: Work>(work: W, most: Vectors) {
    here(work, most);
}

/// Does the work in the registers and on the cores of this processor. The states are split in halves for idle cores,
/// down to [`SHARE`]; the split changes no result.
#[cfg(feature = "rayon")]
pub(super) fn run<W: Work>(work: W, most: Vectors) {
    let states = work.states();
    if states <= SHARE {
        here(work, most);
    } else {
        // A multiple of 16, so that only the last pack is incomplete.
        let (first, rest) = work.split((states / 2).next_multiple_of(16));
        rayon::join(|| run(first, most), || run(rest, most));
    }
}

/// The number of states that are not split further: ten microseconds of the inverse dynamics of an arm.
#[cfg(feature = "rayon")]
const SHARE: usize = 512;

/// Does the work on this core.
fn here<W: Work>(work: W, most: Vectors) {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    let Some(work) = x86::run(work, most) else {
        return;
    };
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    let _ = most;
    work.plain();
}

/// Processors with more instructions than their target.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod x86 {
    use super::{Narrow, Short, Vectors, Wide, Work};
    use crate::scalar::rounding::{OfTarget, Rounding};
    use pulp::NullaryFnOnce;

    /// Work, to be compiled for a processor.
    struct For<P, W>(P, W);

    macro_rules! work {
        ($($processor:ident $method:ident)*) => {$(
            impl<W: Work> NullaryFnOnce for For<$processor, W> {
                type Output = ();

                #[inline(always)]
                fn call(self) {
                    self.1.$method(self.0);
                }
            }
        )*};
    }
    work!(Short short Narrow narrow Wide wide);

    /// Does the work in the registers of this processor; returns it if there are none to use.
    pub(super) fn run<W: Work>(work: W, most: Vectors) -> Option<W> {
        if most >= Vectors::Bits512
            && let Some(processor) = Wide::try_new()
        {
            processor.vectorize(For(processor, work));
        } else if let Some(processor) = Narrow::try_new() {
            processor.vectorize(For(processor, work));
        } else if !OfTarget::FUSES
            && let Some(processor) = Short::try_new()
        {
            // These registers do not fuse products with sums.
            processor.vectorize(For(processor, work));
        } else {
            return Some(work);
        }
        None
    }
}

/// Number of packs that are filled before the first is used. Their lanes are written one by one, and must have left
/// the processor's store queue before they are read as vectors.
pub(super) const FILLED: usize = 8;

/// Packs of zeros, to be filled.
#[inline(always)]
pub(super) fn empty<T: Default, P: Packs<T>, const N: usize>(
    processor: P::Processor,
) -> [[P; N]; FILLED] {
    [[P::filled(processor, T::default()); N]; FILLED]
}

/// Fills packs with states; packs beyond the last state keep their numbers.
#[inline(always)]
pub(super) fn load<T, P: Packs<T>, const N: usize>(
    states: &[[T; N]],
    packs: &mut [[P; N]; FILLED],
) {
    for (packs, states) in packs.iter_mut().zip(states.chunks(P::LANES)) {
        P::load(states, packs);
    }
}
