//! Robots in batches: the names of the functions that batches compile for the processor at hand.
//!
//! In: a robot's list of these names. Out: the trait bound of batches, and a lookup at compile time.

use super::chain::Chain;

/// A robot that takes part in batches, the methods of `homogen::batch::Batch`.
///
/// Robots that are generated implement it. A robot that implements the traits of functions by hand writes
/// `impl homogen::robot::Batched for MyRobot {}`.
pub trait Batched {
    /// Names of the functions that are inlined completely into their callers and make their constants
    /// [like](crate::Scalar::like) the numbers of `q`. Batches compile these for the processor that the program runs on,
    /// and hold their numbers in registers from the start.
    const INLINED: &'static [&'static str] = &[];
}

impl<const N: usize, const F: usize, const Q: usize, const B: usize> Batched for Chain<N, F, Q, B> {}

/// True if a function is in the list of a robot.
#[cfg(feature = "batch")]
pub(crate) const fn is_inlined<R: Batched + ?Sized>(function: &str) -> bool {
    let mut rest = R::INLINED;
    while let [name, others @ ..] = rest {
        if is_same(name.as_bytes(), function.as_bytes()) {
            return true;
        }
        rest = others;
    }
    false
}

#[cfg(feature = "batch")]
const fn is_same(mut a: &[u8], mut b: &[u8]) -> bool {
    while let ([first, a_rest @ ..], [other, b_rest @ ..]) = (a, b) {
        if *first != *other {
            return false;
        }
        (a, b) = (a_rest, b_rest);
    }
    a.is_empty() && b.is_empty()
}
