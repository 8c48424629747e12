//! Part II: open chains, closed loops, and both formulations of the dynamics.
//!
//! Random numbers have 24 bits, so that they are the same number in f32 and in f64. Tolerances are in
//! units of rounding of the tested type, scaled by the size of what is summed.

#![cfg(any(feature = "std", feature = "libm"))]

mod jet;
mod lagrange;
mod loop_closure;
mod open_chain;
mod sample;
mod several;
mod slider_crank;
mod stanford_arm;
mod steps;
