//! A number as a description has it: not only its value.
//!
//! A shared noun: how it is read, and what its digits may mean, is for others to say.

use crate::error::Place;

/// A number, the digits it was written with, and its place.
#[derive(Clone, Copy, Debug, Default)]
pub struct Number {
    /// The nearest `f64`.
    pub value: f64,
    /// One unit of the last digit that was written: 1e-4 for `1.5708`, 1e-6 for `1.5e-5`.
    /// Zero where the number was not read from digits.
    pub resolution: f64,
    /// Where it stands.
    pub place: Place,
}
