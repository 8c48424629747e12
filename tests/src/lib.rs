//! What the tests share: the robots, random states and trees, a dual number, numbers of 256 bits, the
//! truth in them, the measures of error.
//!
//! In: robots/*.urdf, seeds. Out: structs with generated functions, and numbers that are the same
//! on every machine. It never decides whether a test passes, except in [`rounding`].

pub mod arguments;
pub mod big;
pub mod cholesky;
pub mod climb;
pub mod drives;
pub mod dual;
pub mod fire;
pub mod functions;
pub mod fused_sines;
pub mod hexadecimal;
pub mod humanoid;
pub mod jointed;
pub mod mechanisms;
pub mod metrics;
pub mod oracle;
pub mod programs;
pub mod robots;
pub mod rounding;
mod scalars;
pub mod sources;
pub mod states;
pub mod subjects;
pub mod tested;
pub mod trees;
