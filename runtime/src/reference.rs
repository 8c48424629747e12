//! What generated code is held against.
//!
//! Here belongs every function of a robot, computed at run time from the robot as data by dense 4×4
//! products. Of the typed matrices it takes the numbers alone: exponentials, changes of frame and
//! products are written once more, so that a mistake in them is not made on both sides. Nothing here
//! is simplified or fast, and nothing else in the crate calls it.

mod dense;
mod derivatives;
pub mod generic;
mod motion;
mod traits;
