//! What the robot's functions compute with: a number alone, or several side by side.
//!
//! Every lane has the bits that the number alone would have, NaN and infinities among them: products and
//! sums are rounded one by one, on every processor.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::real::{LIMIT, Real, sin_cos};

/// A number as straight-line code needs it.
#[allow(dead_code, reason = "not every robot needs every operation")]
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number nearest to `value`, on the processor of `self`.
    fn like(self, value: f64) -> Self;

    /// The square root.
    fn sqrt(self) -> Self;

    /// −1, 0 or 1; 0 of NaN.
    fn sgn(self) -> Self;

    /// Sine and cosine of an angle, by the platform.
    fn sin_cos(self) -> (Self, Self);

    /// The sines and the cosines of all angles: this package's own up to `LIMIT`, the platform's beyond.
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
    fn sgn(self) -> Self {
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

/// Whether an angle has sines of this package's own.
#[inline(always)]
pub fn is_moderate(angle: Real) -> bool {
    angle.abs() <= LIMIT
}

/// Numbers that one state each is put in.
pub trait Lanes: Number {
    /// How many there are.
    const COUNT: usize;

    /// The proof that the processor has the instructions that they are computed with.
    type Processor: Copy;

    /// The same number in each lane.
    fn filled(processor: Self::Processor, number: Real) -> Self;

    /// Takes the numbers of a state into each lane; where states are fewer the others get the last one.
    fn load<const N: usize>(states: &[[Real; N]], numbers: &mut [Self; N]);

    /// Writes the numbers of the first lanes, one after the other; `room` says how many.
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
