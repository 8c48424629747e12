//! What the small programs share.
//!
//! Random states, the functions of a robot called by name, times with the machine they were
//! measured on; and what is written once for all robots: controllers, a filter, an optimiser. Nothing here is needed to
//! use `homogen`.

pub mod bound;
pub mod control;
pub mod drawing;
pub mod entries;
pub mod filter;
pub mod machine;
pub mod motion;
pub mod optimal;
pub mod price;
pub mod states;
pub mod timing;

/// The README, so that its blocks of Rust are compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
