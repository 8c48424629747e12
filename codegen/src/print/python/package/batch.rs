//! Many states: by the widest vectors of the processor, and by all its cores.
//!
//! Results have the same bits for any vectors and cores.

use std::sync::{Arc, Mutex};

use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::number::Lanes;
use crate::real::{Real, WIDE};

/// Argument of some states, with `N` numbers each.
#[derive(Clone, Copy)]
pub enum Argument<'a, const N: usize> {
    /// One for each state.
    Each(&'a [[Real; N]]),
    /// One for all states.
    Same(&'a [Real; N]),
}

impl<'a, const N: usize> Argument<'a, N> {
    /// The argument from the numbers of all states in order, or of one for all.
    pub fn of(numbers: &'a [Real], is_for_all: bool) -> Self {
        let (states, _) = numbers.as_chunks();
        if is_for_all {
            Self::Same(&states[0])
        } else {
            Self::Each(states)
        }
    }

    /// The parts for the states before `at` and from it on.
    pub fn split(self, at: usize) -> (Self, Self) {
        match self {
            Self::Each(states) => {
                let (first, rest) = states.split_at(at);
                (Self::Each(first), Self::Each(rest))
            }
            Self::Same(_) => (self, self),
        }
    }
}

/// A function of some states.
pub trait Work: Sized + Send {
    /// Number of states.
    fn states(&self) -> usize;

    /// The work on the states before `at` and from it on.
    fn split(self, at: usize) -> (Self, Self);

    /// Does it for as many states at a time as `P` has lanes.
    fn by<P: Lanes>(self, processor: P::Processor);
}

/// The functions of a robot, each as a struct with the same name that holds states and memory for results.
macro_rules! functions {
    ($robot:ty: $(
        $name:ident($($argument:ident: $width:literal),*) -> ($($result:ident: $size:literal),*);
    )*) => {$(
        #[allow(non_camel_case_types, reason = "each is called as its function")]
        pub struct $name<'a> {
            pub robot: &'a $robot,
            pub states: usize,
            $(pub $argument: $crate::batch::Argument<'a, $width>,)*
            $(pub $result: &'a mut [$crate::real::Real],)*
        }

        impl $crate::batch::Work for $name<'_> {
            fn states(&self) -> usize {
                self.states
            }

            fn split(self, at: usize) -> (Self, Self) {
                let Self { robot, states, .. } = self;
                $(let $argument = self.$argument.split(at);)*
                $(let $result = self.$result.split_at_mut(at * $size);)*
                (
                    Self { robot, states: at, $($argument: $argument.0,)* $($result: $result.0,)* },
                    Self { robot, states: states - at, $($argument: $argument.1,)* $($result: $result.1,)* },
                )
            }

            #[inline(always)]
            fn by<P: $crate::number::Lanes>(self, processor: P::Processor) {
                $(let mut $argument = $crate::batch::empty::<P, $width>(processor);)*
                let mut first = 0;
                while first < self.states {
                    let count = (self.states - first).min(P::COUNT * $crate::batch::FILLED);
                    $($crate::batch::load(&self.$argument, first, count, &mut $argument);)*
                    for (pack, begin) in (0..count).step_by(P::COUNT).enumerate() {
                        let results = self.robot.$name($(&$argument[pack]),*);
                        let lanes = (count - begin).min(P::COUNT);
                        let ($($result,)*) = &results;
                        $(
                            let room = &mut self.$result[(first + begin) * $size..][..lanes * $size];
                            P::store::<$size>($result, room);
                        )*
                    }
                    first += count;
                }
            }
        }
    )*};
}
pub(crate) use functions;

/// Number of packs that are filled before the first is used, so that their lanes, which are written in parts, have
/// left the processor's store queue when they are read.
pub const FILLED: usize = 8;

/// Packs to be filled.
#[inline(always)]
pub fn empty<P: Lanes, const N: usize>(processor: P::Processor) -> [[P; N]; FILLED] {
    [[P::filled(processor, 0.0); N]; FILLED]
}

/// Fills packs with the available states.
#[inline(always)]
pub fn load<P: Lanes, const N: usize>(
    argument: &Argument<'_, N>,
    first: usize,
    count: usize,
    packs: &mut [[P; N]; FILLED],
) {
    match argument {
        Argument::Each(states) => {
            let states = states[first..first + count].chunks(P::COUNT);
            for (pack, states) in packs.iter_mut().zip(states) {
                P::load(states, pack);
            }
        }
        Argument::Same(state) => {
            for pack in packs {
                P::load(std::slice::from_ref(*state), pack);
            }
        }
    }
}

/// Number of states for one task of a core: ten microseconds of the inverse dynamics of an arm.
const SHARE: usize = 512;

/// Does the work with the vectors and the cores of this processor.
pub fn run<W: Work>(work: W) {
    if work.states() <= SHARE {
        here(work);
    } else if let Some(pool) = pool() {
        pool.install(|| shared(work));
    } else {
        here(work);
    }
}

/// Splits the work in halves for idle cores, down to the size of a task.
fn shared<W: Work>(work: W) {
    let states = work.states();
    if states <= SHARE {
        here(work);
    } else {
        // Whole packs leave the remainder to the last part.
        let (first, rest) = work.split((states / 2).next_multiple_of(WIDE));
        rayon::join(|| shared(first), || shared(rest));
    }
}

/// The threads of this process, if it can have any: a process created by `fork` has none of its parent's threads.
fn pool() -> Option<Arc<ThreadPool>> {
    static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
    let process = std::process::id();
    let mut own = POOL.lock().ok()?;
    if let Some((of, pool)) = &*own
        && *of == process
    {
        return Some(Arc::clone(pool));
    }
    let pool = Arc::new(ThreadPoolBuilder::new().build().ok()?);
    // The threads of the parent do not exist here, so that the pool cannot be dropped.
    std::mem::forget(own.replace((process, Arc::clone(&pool))));
    Some(pool)
}

/// Does the work on this core.
fn here<W: Work>(work: W) {
    if work.states() <= 2 {
        work.by::<Real>(());
    } else {
        vectors::run(work);
    }
}

/// Processors that may have more instructions than the compilation target.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
mod vectors {
    use super::Work;
    use crate::pack::Pack;
    use crate::processor::Vectors;
    use crate::real::{NARROW, Real, WIDE};
    use pulp::NullaryFnOnce;
    use pulp::x86::{V3, V4};

    /// Work for a processor with this number of lanes.
    struct By<P, W, const L: usize>(P, W);

    impl<P: Vectors<L>, W: Work, const L: usize> NullaryFnOnce for By<P, W, L> {
        type Output = ();

        #[inline(always)]
        fn call(self) {
            self.1.by::<Pack<P, L>>(self.0);
        }
    }

    /// By AVX-512, AVX2, or one state at a time.
    pub fn run<W: Work>(work: W) {
        if let Some(processor) = V4::try_new() {
            processor.vectorize(By::<_, _, WIDE>(processor, work));
        } else if let Some(processor) = V3::try_new() {
            processor.vectorize(By::<_, _, NARROW>(processor, work));
        } else {
            work.by::<Real>(());
        }
    }
}

/// Processors whose vector instructions are always available.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
mod vectors {
    use super::Work;
    use crate::pack::Pack;
    use crate::real::NARROW;

    pub fn run<W: Work>(work: W) {
        work.by::<Pack<(), NARROW>>(());
    }
}
