//! Expands the 4×4 matrices of a robot into straight-line Rust.
//!
//! ```text
//! description ──► chain ──► layout ──► model ──► simplify ──► schedule ──► print
//!  what the        what it    which     4×4       fewer         a routine:   rust, c,
//!  user wrote      means      frames    matrices  operations    names,       python
//!                             and       of Expr                 statements,
//!                             numbers                           spaces
//! ```

pub mod builder;
#[cfg(feature = "cli")]
pub mod cli;
pub mod description;
pub mod error;
pub mod formulation;
pub mod function;
pub mod processor;
mod random;
pub mod real;
pub mod request;

// Not for users: what the macros call, and the stages and nouns that the project's own tests and
// reports look at.
#[doc(hidden)]
pub mod accuracy;
#[doc(hidden)]
pub mod chain;
#[doc(hidden)]
pub mod check;
#[doc(hidden)]
pub mod closure;
mod dense;
#[doc(hidden)]
pub mod door;
#[doc(hidden)]
pub mod expand;
#[doc(hidden)]
pub mod expression;
#[doc(hidden)]
pub mod joint;
#[doc(hidden)]
pub mod layout;
#[doc(hidden)]
pub mod matrix;
#[doc(hidden)]
pub mod model;
#[doc(hidden)]
pub mod number;
#[doc(hidden)]
pub mod print;
#[doc(hidden)]
pub mod schedule;
#[doc(hidden)]
pub mod simplify;
#[doc(hidden)]
pub mod space;
mod wording;

pub use builder::Builder;
pub use formulation::Formulation;
pub use function::Function;
pub use processor::Processor;
pub use real::Real;
pub use request::Target;
