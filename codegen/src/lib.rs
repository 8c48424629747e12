//! Expands the 4×4 matrices of a robot into straight-line Rust.
//!
//! ```text
//! description ──► chain ──► layout ──► model ──► simplify ──► schedule ──► print
//!  what the        what it    which     4×4       fewer         a routine:   rust, c
//!  user wrote      means      frames    matrices  operations    names,
//!                             and       of Expr                 statements,
//!                             numbers                           spaces
//! ```

pub mod accuracy;
pub mod builder;
pub mod chain;
pub mod check;
#[cfg(feature = "cli")]
pub mod cli;
mod dense;
pub mod description;
pub mod door;
pub mod error;
pub mod expand;
pub mod expression;
pub mod formulation;
pub mod function;
pub mod joint;
pub mod layout;
pub mod matrix;
pub mod model;
pub mod number;
pub mod print;
pub mod processor;
pub mod real;
pub mod request;
pub mod schedule;
pub mod simplify;
pub mod space;
mod wording;

pub use builder::Builder;
pub use formulation::Formulation;
pub use function::Function;
pub use processor::Processor;
pub use real::Real;
pub use request::Target;
