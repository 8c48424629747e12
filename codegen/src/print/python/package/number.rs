//! What the robot's functions compute with: a number alone, or several side by side.
//!
//! Every lane has the bits that the number alone would have, NaN and infinities among them: products and
//! sums are rounded one by one, on every processor.

use std::array::from_fn;
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
    /// The number nearest to `value`.
    fn constant(value: f64) -> Self;

    /// The square root.
    fn sqrt(self) -> Self;

    /// −1, 0 or 1; 0 of NaN.
    fn sgn(self) -> Self;

    /// φ − sin φ of an angle φ and its sine, which holds its digits near zero.
    fn less_sine(self, sine: Self) -> Self;

    /// Sine and cosine of an angle, by the platform.
    fn sin_cos(self) -> (Self, Self);

    /// The sines and the cosines of all angles: this file's own up to `LIMIT`, the platform's beyond.
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]);
}

impl Number for Real {
    #[inline(always)]
    fn constant(value: f64) -> Self {
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
    fn less_sine(self, sine: Self) -> Self {
        // φ³/6 (1 − φ²/20 (1 − φ²/42 (1 − …))): enough of it for `f64` up to 2.
        let square = self * self;
        let bracket = (2..=SERIES).rev().fold(1.0, |bracket, k| {
            let n = 2.0 * f64::from(k);
            1.0 - square * Self::constant(1.0 / (n * (n + 1.0))) * bracket
        });
        let series = self * square * bracket / 6.0;
        if self.abs() < 2.0 {
            series
        } else {
            self - sine
        }
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

/// How many terms φ − sin φ has.
const SERIES: u8 = 12;

/// Sine and cosine of an angle of any size.
#[inline(always)]
fn of_any(angle: Real) -> (Real, Real) {
    if is_moderate(angle) {
        sin_cos(angle)
    } else {
        angle.sin_cos()
    }
}

#[inline(always)]
fn is_moderate(angle: Real) -> bool {
    angle.abs() <= LIMIT
}

/// Several numbers that take the same steps, which become vector instructions.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Pack<const L: usize>(pub [Real; L]);

/// Implements an operator of two packs by that of their lanes.
macro_rules! operator {
    ($name:ident $method:ident $count:literal [$($lane:literal)*]) => {
        impl $name for Pack<$count> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self([$(self.0[$lane].$method(other.0[$lane])),*])
            }
        }
    };
}

/// Packs of so many lanes, written out: a loop for every operation of a long function is more than compilers
/// can follow.
macro_rules! pack {
    ($count:literal [$($lane:literal)*]) => {
        operator!(Add add $count [$($lane)*]);
        operator!(Sub sub $count [$($lane)*]);
        operator!(Mul mul $count [$($lane)*]);
        operator!(Div div $count [$($lane)*]);

        impl Neg for Pack<$count> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self([$(-self.0[$lane]),*])
            }
        }

        impl Number for Pack<$count> {
            #[inline(always)]
            fn constant(value: f64) -> Self {
                Self([Real::constant(value); $count])
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                Self([$(self.0[$lane].sqrt()),*])
            }

            #[inline(always)]
            fn sgn(self) -> Self {
                Self([$(self.0[$lane].sgn()),*])
            }

            #[inline(always)]
            fn less_sine(self, sine: Self) -> Self {
                Self([$(self.0[$lane].less_sine(sine.0[$lane])),*])
            }

            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                two(self, Real::sin_cos)
            }

            #[inline(always)]
            fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                of_all(angles)
            }
        }
    };
}
pack!(4 [0 1 2 3]);
pack!(8 [0 1 2 3 4 5 6 7]);
pack!(16 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15]);

/// While every angle of every lane is moderate the code is straight; beyond it, after one branch for all, they
/// go one by one.
#[inline(always)]
fn of_all<const L: usize, const N: usize>(angles: [Pack<L>; N]) -> ([Pack<L>; N], [Pack<L>; N]) {
    let mut moderate = true;
    for angle in &angles {
        for &lane in &angle.0 {
            moderate &= is_moderate(lane);
        }
    }
    if !moderate {
        return one_by_one(angles);
    }
    let (mut sines, mut cosines) = (angles, angles);
    for (sine, cosine) in sines.iter_mut().zip(&mut cosines) {
        (*sine, *cosine) = two(*sine, sin_cos);
    }
    (sines, cosines)
}

/// The sines and cosines of angles of any size.
#[cold]
#[inline(never)]
fn one_by_one<const L: usize, const N: usize>(
    angles: [Pack<L>; N],
) -> ([Pack<L>; N], [Pack<L>; N]) {
    let pairs = angles.map(|angle| two(angle, of_any));
    (pairs.map(|(sine, _)| sine), pairs.map(|(_, cosine)| cosine))
}

/// Two results of each lane.
#[inline(always)]
fn two<const L: usize>(
    pack: Pack<L>,
    operation: impl Fn(Real) -> (Real, Real),
) -> (Pack<L>, Pack<L>) {
    let (mut first, mut second) = (pack, pack);
    for (first, second) in first.0.iter_mut().zip(&mut second.0) {
        (*first, *second) = operation(*first);
    }
    (first, second)
}

/// Numbers that one state each is put in.
pub trait Lanes: Number {
    /// How many there are.
    const COUNT: usize;

    /// The number of each lane.
    fn of(lanes: impl Fn(usize) -> Real) -> Self;

    /// The number of one lane, which must be one.
    fn lane(&self, lane: usize) -> Real;
}

impl Lanes for Real {
    const COUNT: usize = 1;

    #[inline(always)]
    fn of(lanes: impl Fn(usize) -> Real) -> Self {
        lanes(0)
    }

    #[inline(always)]
    fn lane(&self, _: usize) -> Real {
        *self
    }
}

impl<const L: usize> Lanes for Pack<L>
where
    Self: Number,
{
    const COUNT: usize = L;

    #[inline(always)]
    fn of(lanes: impl Fn(usize) -> Real) -> Self {
        Self(from_fn(lanes))
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> Real {
        self.0[lane]
    }
}
