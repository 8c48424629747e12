//! Values of the robot's functions: a number, or several in the lanes of vectors.
//!
//! Every lane has the same bits as a single number, NaN and infinities included: products and sums are rounded
//! separately on every processor.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::real::{LIMIT, Real, sin_cos};

/// A value of straight-line code.
#[allow(dead_code, reason = "not every robot needs every operation")]
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number nearest to `value`, for the processor of `self`.
    fn like(self, value: f64) -> Self;

    /// The square root.
    fn sqrt(self) -> Self;

    /// −1, 0 or 1; 0 of NaN.
    fn sign(self) -> Self;

    /// Sine and cosine of an angle, by the platform.
    fn sin_cos(self) -> (Self, Self);

    /// The sines and the cosines of all angles: those of this package up to `LIMIT`, those of the platform beyond.
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]);
}

impl Number for Real {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        value as Self
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn sign(self) -> Self {
        Self::from(i8::from(self > 0.0) - i8::from(self < 0.0))
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }

    #[inline(always)]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let pairs = angles.map(of_any);
        (pairs.map(|(sine, _)| sine), pairs.map(|(_, cosine)| cosine))
    }
}

/// Sine and cosine of an angle of any size.
#[inline(always)]
pub fn of_any(angle: Real) -> (Real, Real) {
    if is_moderate(angle) {
        sin_cos(angle)
    } else {
        angle.sin_cos()
    }
}

/// True if an angle is in the range of this package's sines.
#[inline(always)]
pub fn is_moderate(angle: Real) -> bool {
    angle.abs() <= LIMIT
}

/// Values with a lane for each state.
pub trait Lanes: Number {
    /// Number of lanes.
    const COUNT: usize;

    /// Token that shows that the processor has the instructions.
    type Processor: Copy;

    /// The same number in each lane.
    fn filled(processor: Self::Processor, number: Real) -> Self;

    /// Loads a state into each lane; the remaining lanes repeat the last state.
    fn load<const N: usize>(states: &[[Real; N]], numbers: &mut [Self; N]);

    /// Stores the numbers of the first lanes in order, as many as `room` holds.
    fn store<const N: usize>(numbers: &[Self; N], room: &mut [Real]);
}

impl Lanes for Real {
    const COUNT: usize = 1;
    type Processor = ();

    #[inline(always)]
    fn filled((): (), number: Real) -> Self {
        number
    }

    #[inline(always)]
    fn load<const N: usize>(states: &[[Real; N]], numbers: &mut [Self; N]) {
        *numbers = states[0];
    }

    #[inline(always)]
    fn store<const N: usize>(numbers: &[Self; N], room: &mut [Real]) {
        room.copy_from_slice(numbers);
    }
}
