//! The theory of the paper as a library, and the programs that have always come with it.
//!
//! Here belong the ways into and out of the matrices (angles, frames from points, Denavit and
//! Hartenberg's numbers, the logarithm, the nearest rotation), the geometry of points, lines and
//! planes, and Part II as it is printed: open chains, Lagrange, closed loops and two worked
//! examples. It is there to be used and read: generated code names nothing of it, and what generated
//! functions return is not held against it, but against the recursions in `reference`.

pub mod angles;
pub mod denavit_hartenberg;
pub mod frames;
pub mod geometry;
pub mod lagrange;
mod logarithm;
pub mod loop_closure;
pub mod newton_euler;
pub mod normalize;
pub mod open_chain;
pub(crate) mod singular_values;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod worked_examples;
