//! Numbers of a description, with their digits and places.

use crate::error::Place;
use crate::expression::Double;

/// A number with its digits and its place.
#[derive(Clone, Copy, Debug, Default)]
pub struct Number {
    /// The nearest `f64`.
    pub value: f64,
    /// The number minus `value`, to 53 further bits. Zero for a number written in digits, which means its nearest
    /// `f64`; not zero for `pi/3` or a number computed from others.
    pub rest: f64,
    /// One unit of the last written digit: 1e-4 for `1.5708`, 1e-6 for `1.5e-5`. Zero if the number was not read from
    /// digits.
    pub resolution: f64,
    /// Its place in the text.
    pub place: Place,
}

/// A computed number, without digits.
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
    /// A number without a place, set in code.
    fn from(value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }
}

impl Number {
    /// The number to 106 bits. Computations start from this, not from the nearest `f64`.
    #[must_use]
    pub fn exact(&self) -> Double {
        Double::from(self.value) + Double::from(self.rest)
    }
}
