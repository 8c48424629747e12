//! A number as a description has it: not only its value.
//!
//! A shared noun: how it is read, and what its digits may mean, is for others to say.

use crate::error::Place;
use crate::expression::Double;

/// A number, the digits it was written with, and its place.
#[derive(Clone, Copy, Debug, Default)]
pub struct Number {
    /// The nearest `f64`.
    pub value: f64,
    /// What that lacks of the number, to 53 further bits. Zero of a number written in digits, which means the
    /// nearest `f64`; not of `pi/3`, or of a number that is computed of others.
    pub rest: f64,
    /// One unit of the last digit that was written: 1e-4 for `1.5708`, 1e-6 for `1.5e-5`.
    /// Zero where the number was not read from digits.
    pub resolution: f64,
    /// Where it stands.
    pub place: Place,
}

/// A number that was computed and not written.
#[must_use]
pub fn computed(number: impl Into<Double>, place: Place) -> Number {
    let number = number.into();
    let value = number.to_f64();
    Number {
        value,
        rest: (number - Double::from(value)).to_f64(),
        resolution: 0.0,
        place,
    }
}

impl From<f64> for Number {
    /// A number that was written nowhere: a build script's.
    fn from(value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }
}

impl Number {
    /// The number to 106 bits: whatever is computed of it begins here, and never with its nearest `f64`.
    #[must_use]
    pub fn exact(&self) -> Double {
        Double::from(self.value) + Double::from(self.rest)
    }
}
