//! Symbolic scalars: a hash-consed graph of arithmetic.
//!
//! In: numbers, inputs, operations. Out: a [`Graph`] in which children come before parents and equal expressions are
//! one node, in a canonical form fixed at construction (`graph.rs` lists it). Equal calls give equal graphs on every
//! platform.

mod derivative;
mod double;
mod evaluate;
mod graph;
mod label;
mod substitute;
mod term;

pub use derivative::{along, along_known, gradient};
pub use double::Double;
pub use evaluate::{Arithmetic, Evaluation, evaluate};
pub use graph::{Expr, Graph, Input, Node, Operands};
pub use label::{Block, Component, Label, LabelledBodies, Numeral, Quantity};
pub use substitute::substitute;
pub use term::Term;
