//! The two worked examples of Part II, in closed form.
//!
//! In: coordinates and rates. Out: closed-form results, derived by hand from the matrices of the joints. Tests
//! compare every formula with the recursions; nothing in the library calls them.

pub mod slider_crank;
pub mod stanford_arm;
