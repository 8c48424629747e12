//! What the tests share: the robots, random states and trees, a dual number, single precision
//! without subnormal numbers, numbers of 256 bits, the measure of error.
//!
//! In: robots/*.urdf, seeds. Out: structs with generated functions, and numbers that are the same
//! on every machine. It never decides whether a test passes, except in [`rounding`].

pub mod big;
pub mod dual;
pub mod flushed;
pub mod functions;
pub mod robots;
pub mod rounding;
pub mod states;
pub mod trees;
