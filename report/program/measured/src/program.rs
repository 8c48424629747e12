//! A program over many states.
//!
//! In: a closure for one state or a slice of them, or a library of another program. Out: a [`Program`] over lists of
//! states, on all threads of the pool that it runs in; idle threads take shares of the states, as in a batch.

use std::error::Error;
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use homogen::batch::Vectors;
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::library::Foreign;

/// q, q̇, and q̈ or τ of many states, one state after the other in each.
pub type Lists<'a, T> = [&'a [T]; 3];

/// A function from lists to results.
pub type Run<T> = Box<dyn Fn(Lists<'_, T>, &mut [T])>;

/// A program whose time and errors are measured.
pub struct Program<T> {
    /// Its name.
    pub name: String,
    /// Computes all states.
    pub run: Run<T>,
}

/// Number of states in a share of a thread: the same as in a batch.
const SHARE: usize = 512;

#[allow(
    dead_code,
    reason = "the generated robots need it, where there are any"
)]
impl<T: Copy + Send + Sync + 'static> Program<T> {
    /// A program that calls a function for each state.
    pub fn alone<const NQ: usize, const NV: usize>(
        name: &str,
        function: impl Fn(&[T; NQ], &[T; NV], &[T; NV]) -> [T; NV] + Sync + 'static,
    ) -> Self {
        let run: Run<T> = Box::new(move |lists, results| {
            in_shares([NQ, NV, NV], lists, NV, results, |[q, qd, x], results| {
                let rates = qd.as_chunks().0.iter().zip(x.as_chunks().0);
                let states = q.as_chunks().0.iter().zip(rates);
                for ((q, (qd, x)), result) in states.zip(results.as_chunks_mut().0) {
                    *result = function(q, qd, x);
                }
            });
        });
        Self {
            name: name.to_owned(),
            run,
        }
    }

    /// A program of a function of slices of states, which splits them itself.
    pub fn batch<const NQ: usize, const NV: usize>(
        name: String,
        function: impl Fn(&[[T; NQ]], &[[T; NV]], &[[T; NV]], &mut [[T; NV]]) + 'static,
    ) -> Self {
        let run: Run<T> = Box::new(move |[q, qd, x], results| {
            let (q, qd, x) = (q.as_chunks().0, qd.as_chunks().0, x.as_chunks().0);
            function(q, qd, x, results.as_chunks_mut().0);
        });
        Self { name, run }
    }
}

/// The lengths of registers that this processor has.
#[allow(
    dead_code,
    reason = "the generated robots need it, where there are any"
)]
pub fn kinds() -> impl Iterator<Item = (&'static str, Vectors)> {
    let kinds = [
        (!has_avx2(), "target", Vectors::default()),
        (has_avx2(), "avx2", Vectors::Bits256),
        (has_avx512(), "avx512", Vectors::Bits512),
    ];
    let kinds = kinds.into_iter().filter(|(has, ..)| *has);
    kinds.map(|(_, name, vectors)| (name, vectors))
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn has_avx2() -> bool {
    pulp::x86::V3::try_new().is_some()
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn has_avx512() -> bool {
    pulp::x86::V4::try_new().is_some()
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
const fn has_avx2() -> bool {
    false
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
const fn has_avx512() -> bool {
    false
}

/// A function of another program, loaded once for each thread, because some have their results in static memory of the
/// library.
pub struct Foreigners<T>(Vec<Mutex<Foreign<T>>>);

impl<T: Copy + Send + Sync + 'static> Foreigners<T> {
    /// Loads it for the threads of the pool that this runs in.
    pub fn load(library: &Path, symbol: &str) -> Result<Self, Box<dyn Error>> {
        let mut copies = vec![Mutex::new(Foreign::load(library, symbol)?)];
        for thread in 1..rayon::current_num_threads() {
            // The loader takes the same name for the same library.
            let name = library.file_name().unwrap_or_default().display();
            let name = format!("homogen-{}-{thread}-{name}", std::process::id());
            let copy = std::env::temp_dir().join(name);
            fs::copy(library, &copy)?;
            let loaded = Foreign::load(&copy, symbol);
            fs::remove_file(copy)?;
            copies.push(Mutex::new(loaded?));
        }
        Ok(Self(copies))
    }

    /// The program that calls it for each state, with the arguments in these ranges of a state, and `entries` results.
    pub fn program(self, name: String, places: [Range<usize>; 3], entries: usize) -> Program<T> {
        let lengths = places.map(|place| place.len());
        let run: Run<T> = Box::new(move |lists, results| {
            in_shares(lengths, lists, entries, results, |[q, qd, x], results| {
                let thread = rayon::current_thread_index().unwrap_or_default();
                let foreign = self.0[thread].lock();
                let foreign = foreign.unwrap_or_else(PoisonError::into_inner);
                let rates = qd.chunks_exact(lengths[1]).zip(x.chunks_exact(lengths[2]));
                let states = q.chunks_exact(lengths[0]).zip(rates);
                for ((q, (qd, x)), result) in states.zip(results.chunks_exact_mut(entries)) {
                    foreign.call([q, qd, x], Some(result));
                }
            });
        });
        Program { name, run }
    }
}

/// Computes lists of states with given numbers of entries, in shares.
fn in_shares<T: Send + Sync>(
    lengths: [usize; 3],
    [q, qd, x]: Lists<'_, T>,
    entries: usize,
    results: &mut [T],
    share: impl Fn(Lists<'_, T>, &mut [T]) + Sync,
) {
    let [of_q, of_qd, of_x] = lengths.map(|length| length * SHARE);
    let rates = qd.par_chunks(of_qd).zip(x.par_chunks(of_x));
    let states = q.par_chunks(of_q).zip(rates);
    let all = states.zip(results.par_chunks_mut(entries * SHARE));
    all.for_each(|((q, (qd, x)), results)| share([q, qd, x], results));
}
