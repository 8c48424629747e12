//! The theory of the paper as a library, with the functions of its companion SPACELIB.
//!
//! - Conversions to and from the matrices: angles, frames from points, Denavit–Hartenberg parameters, the
//!   logarithm, the nearest rotation.
//! - The geometry of points, lines and planes.
//! - Part II: open chains, Lagrange, closed loops and two worked examples.
//!
//! Generated code does not use this module, and its tests compare it with `reference` instead.

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
