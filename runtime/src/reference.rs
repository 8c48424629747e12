//! The reference of the tests of generated code.
//!
//! Every function of a robot, computed at run time from the robot as data by dense 4×4 products. Only
//! the numbers of the typed matrices are used: exponentials, changes of frame and products are written
//! again, so that the two sides share no mistake. Nothing here is simplified or fast, and nothing else
//! in the crate calls it.

mod closure;
mod dense;
mod derivatives;
pub mod generic;
mod hessian;
mod motion;
mod traits;
