//! The two mechanisms that Part II works out, in closed form.
//!
//! In: coordinates and rates. Out: what a person obtains with pencil and paper from the matrices of
//! the joints; the tests hold every formula against the recursions. They are examples to read, and
//! references to compare with; nothing in the library calls them.

pub mod slider_crank;
pub mod stanford_arm;
