//! Expands the 4×4 matrices of a robot into straight-line Rust.
//!
//! ```text
//! description ──► chain ──► model ──► simplify ──► schedule ──► emit
//!  what the        what it    4×4       fewer         order,      tokens
//!  user wrote      means      matrices  operations    live ranges
//!                             of Expr
//! ```

pub mod accuracy;
pub mod builder;
pub mod chain;
pub mod check;
#[cfg(feature = "cli")]
pub mod cli;
pub mod description;
pub mod door;
pub mod emit;
pub mod error;
pub mod expand;
pub mod expression;
pub mod formulation;
pub mod function;
pub mod matrix;
pub mod model;
pub mod request;
pub mod schedule;
pub mod simplify;
pub mod target;
mod wording;

pub use builder::Builder;
pub use formulation::Formulation;
pub use function::Function;
pub use request::{Real, Target};
pub use target::Processor;
