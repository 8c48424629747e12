//! What the small programs share.
//!
//! Random states, the functions of a robot called by name, times with the machine they were
//! measured on. Nothing here is needed to use `homogen`.

pub mod bound;
pub mod entries;
pub mod machine;
pub mod price;
pub mod states;
pub mod timing;

/// The README, so that its blocks of Rust are compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;
