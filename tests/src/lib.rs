//! Shared code of the tests: random states and trees, dual numbers, numbers of 256 bits and the truth in them, measures
//! of error.
//!
//! In: seeds. Out: robots and numbers that are the same on every machine. Limits are up to the tests, except in
//! [`rounding`].

pub mod actuators;
pub mod arguments;
pub mod big;
pub mod cholesky;
pub mod climb;
pub mod dual;
pub mod effort;
pub mod fire;
pub mod functions;
pub mod fused_sines;
pub mod hexadecimal;
pub mod humanoid;
pub mod mechanisms;
pub mod metrics;
pub mod oracle;
pub mod programs;
pub mod rounding;
mod scalars;
pub mod sources;
pub mod states;
pub mod subjects;
pub mod tested;
pub mod trees;
