//! Work on many states, by the widest vectors of the processor and, with the feature `rayon`, by all its cores.
//!
//! In: [`Work`] that can be split. Out: nothing but what the work writes. What the work is, it does not know.
#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]

use super::packed::Packs;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use super::processor::{Narrow, Short, Wide};

/// Work on some states, which can be done by packs of any kind.
pub(super) trait Work: Sized + Send {
    /// How many states there are.
    #[cfg(feature = "rayon")]
    fn states(&self) -> usize;

    /// The work on the states before and from `at`.
    #[cfg(feature = "rayon")]
    fn split(self, at: usize) -> (Self, Self);

    /// By packs that every processor computes with.
    fn plain(self);

    /// By registers of 128 bits.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn short(self, processor: Short);

    /// By registers of 256 bits.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn narrow(self, processor: Narrow);

    /// By registers of 512 bits.
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    fn wide(self, processor: Wide);
}

/// The ways of [`Work`] of what has a method `by`, over any packs, and a `robot` with that trait: `T` are its numbers and
/// `M` is how they are rounded.
macro_rules! by_packs {
    ($method:ident) => {
        #[inline(always)]
        fn plain(self) {
            self.by::<T::Plain>(());
        }

        run::by_packs!(@ $method short Short T::InShort, T::Narrow);
        run::by_packs!(@ $method narrow Narrow M::InNarrow<T>, M::Narrow<T>);
        run::by_packs!(@ $method wide Wide M::InWide<T>, M::Wide<T>);
    };
    // By registers where the function is compiled for the processor, and by packs where not.
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

/// How long the registers are that a batch may use; it uses none that the processor has not.
///
/// It changes no result of [`Batch::of`](super::Batch::of).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Vectors {
    /// What the target has: NEON, AVX2 in a build for it; on x86 128 bits at least, where the processor has SSE4.2.
    OfTarget,
    /// Up to 256 bits: AVX2 with FMA.
    Bits256,
    /// Up to 512 bits: AVX-512.
    #[default]
    Bits512,
}

/// Does the work with the vectors that this processor has.
#[cfg(not(feature = "rayon"))]
pub(super) fn run<W: Work>(work: W, most: Vectors) {
    here(work, most);
}

/// Does the work with the vectors and the cores that this processor has: halves are left to whoever is
/// free, down to a size that is worth it. Who does what changes no result.
#[cfg(feature = "rayon")]
pub(super) fn run<W: Work>(work: W, most: Vectors) {
    let states = work.states();
    if states <= SHARE {
        here(work, most);
    } else {
        // Whole packs leave the odd states to the last one.
        let (first, rest) = work.split((states / 2).next_multiple_of(16));
        rayon::join(|| run(first, most), || run(rest, most));
    }
}

/// How many states one core does in one go: ten microseconds of the inverse dynamics of an arm.
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

/// Processors that may have more than their target.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod x86 {
    use super::{Narrow, Short, Vectors, Wide, Work};
    use pulp::NullaryFnOnce;

    /// Work to be compiled for a processor.
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

    /// What the target has itself.
    const OF_TARGET: Vectors = if cfg!(target_feature = "avx512f") {
        Vectors::Bits512
    } else if cfg!(target_feature = "fma") {
        Vectors::Bits256
    } else {
        Vectors::OfTarget
    };

    /// Does the work with the vectors of this processor, or gives it back where it has none.
    pub(super) fn run<W: Work>(work: W, most: Vectors) -> Option<W> {
        let most = match most {
            Vectors::OfTarget => OF_TARGET,
            longer => longer,
        };
        if most >= Vectors::Bits512
            && let Some(processor) = Wide::try_new()
        {
            processor.vectorize(For(processor, work));
        } else if most >= Vectors::Bits256
            && let Some(processor) = Narrow::try_new()
        {
            processor.vectorize(For(processor, work));
        } else if matches!(OF_TARGET, Vectors::OfTarget)
            && let Some(processor) = Short::try_new()
        {
            // Where the target fuses products with sums, they would not round as the number alone does.
            processor.vectorize(For(processor, work));
        } else {
            return Some(work);
        }
        None
    }
}

/// How many packs are filled before the first is computed with, so that their lanes, which are written one
/// by one, have left the processor's queue when they are read together.
pub(super) const FILLED: usize = 8;

/// Packs that are not filled yet.
#[inline(always)]
pub(super) fn empty<T: Default, P: Packs<T>, const N: usize>(
    processor: P::Processor,
) -> [[P; N]; FILLED] {
    [[P::filled(processor, T::default()); N]; FILLED]
}

/// Fills packs with states, as far as these go.
#[inline(always)]
pub(super) fn load<T, P: Packs<T>, const N: usize>(
    states: &[[T; N]],
    packs: &mut [[P; N]; FILLED],
) {
    for (packs, states) in packs.iter_mut().zip(states.chunks(P::LANES)) {
        P::load(states, packs);
    }
}
