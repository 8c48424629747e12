//! SIMD packs: several numbers that are computed together.
//!
//! In: lanes, `f32` or `f64`. Out: [`Pack`], a [`Scalar`] that applies every operation to each lane, so that
//! the compiler makes vector instructions of it. There are no masks and no intrinsics: each lane has the bits
//! of the number alone, on every target.
#![expect(
    clippy::inline_always,
    reason = "an operation that stayed a call would be as slow as a whole function of a robot"
)]

use super::Scalar;
use super::dispatch::{Work, at_hand};
use super::rounding::{OfTarget, Rounding};
use super::trigonometry::{double, single};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `L` numbers of one type: a [`Scalar`] for `L` states of a robot at once.
///
/// `Pack<f64, 4>` and `Pack<f32, 8>` fill a register of AVX, `Pack<f64, 8>` and `Pack<f32, 16>` one of
/// AVX-512; with shorter registers a pack takes several. Every lane has the bits of the number alone, NaN and
/// infinities included; products are fused with sums if those of the number are.
///
/// ```
/// use homogen::{Pack, Scalar};
/// let angles = Pack([0.0, 0.5, 1.0, f64::NAN]);
/// let ([sines], _) = Pack::sin_cos_all([angles]);
/// assert_eq!(sines.0[1], f64::sin_cos_all([0.5]).0[0]);
/// assert!(sines.0[3].is_nan());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Pack<T, const L: usize>(
    /// The lanes.
    pub [T; L],
);

/// The number of a lane: `f32` or `f64`.
pub trait Lane: Scalar + Default + Send + Sync + sealed::Sealed {
    /// True if [`sin_cos_moderate`](Self::sin_cos_moderate) is accurate at this angle.
    #[must_use]
    fn is_moderate(self) -> bool;

    /// Sine and cosine of a moderate angle \[rad\], without branches.
    #[must_use]
    fn sin_cos_moderate<R: Rounding>(self) -> (Self, Self);

    /// Sine and cosine of any angle \[rad\], by this crate's own functions.
    #[must_use]
    fn sin_cos_own<R: Rounding>(self) -> (Self, Self);
}

mod sealed {
    /// Implemented by this crate alone.
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! lane {
    ($float:ident, $sines:ident) => {
        impl Lane for $float {
            #[inline(always)]
            fn is_moderate(self) -> bool {
                self.abs() <= $sines::LIMIT
            }

            #[inline(always)]
            fn sin_cos_moderate<R: Rounding>(self) -> (Self, Self) {
                $sines::sin_cos_moderate_by::<R>(self)
            }

            #[inline]
            fn sin_cos_own<R: Rounding>(self) -> (Self, Self) {
                $sines::sin_cos_by::<R>(self)
            }
        }
    };
}
lane!(f32, single);
lane!(f64, double);

impl<T: Lane, const L: usize> Pack<T, L> {
    #[inline(always)]
    fn each(mut self, operation: impl Fn(T) -> T) -> Self {
        for lane in &mut self.0 {
            *lane = operation(*lane);
        }
        self
    }

    #[inline(always)]
    fn both(mut self, other: Self, operation: impl Fn(T, T) -> T) -> Self {
        for (lane, other) in self.0.iter_mut().zip(&other.0) {
            *lane = operation(*lane, *other);
        }
        self
    }

    /// An operation with two results.
    #[inline(always)]
    fn two(self, operation: impl Fn(T) -> (T, T)) -> (Self, Self) {
        let (mut first, mut second) = (self, self);
        for (first, second) in first.0.iter_mut().zip(&mut second.0) {
            (*first, *second) = operation(*first);
        }
        (first, second)
    }
}

/// Implements an operator of two packs by that of their lanes.
macro_rules! operator {
    ($($name:ident $method:ident)*) => {$(
        impl<T: Lane, const L: usize> $name for Pack<T, L> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.both(other, T::$method)
            }
        }
    )*};
}
operator!(Add add Sub sub Mul mul Div div);

impl<T: Lane, const L: usize> Neg for Pack<T, L> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.each(T::neg)
    }
}

impl<T: Lane, const L: usize> Scalar for Pack<T, L> {
    const IS_PACK: bool = true;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([T::constant(value); L])
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, term: Self) -> Self {
        self.mul_add_by::<OfTarget>(factor, term)
    }

    #[inline(always)]
    fn mul_add_by<R: Rounding>(mut self, factor: Self, term: Self) -> Self {
        for ((lane, factor), term) in self.0.iter_mut().zip(&factor.0).zip(&term.0) {
            *lane = lane.mul_add_by::<R>(*factor, *term);
        }
        self
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.each(T::sqrt)
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        self.two(T::sin_cos)
    }

    #[inline(always)]
    fn minus_sine(self, sine: Self) -> Self {
        self.both(sine, T::minus_sine)
    }

    #[inline(always)]
    fn sign(self) -> Self {
        self.each(T::sign)
    }

    #[inline(always)]
    fn sin_cos_all<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        Self::sin_cos_all_by::<OfTarget, N>(angles)
    }

    /// Straight-line code if every angle of every lane is moderate; otherwise, after one branch for all, angles are
    /// computed one by one.
    #[inline(always)]
    fn sin_cos_all_by<R: Rounding, const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let mut moderate = true;
        for angle in &angles {
            for lane in &angle.0 {
                moderate &= lane.is_moderate();
            }
        }
        if !moderate {
            return one_by_one::<R, T, L, N>(angles);
        }
        let (mut sines, mut cosines) = (angles, angles);
        for (sine, cosine) in sines.iter_mut().zip(&mut cosines) {
            (*sine, *cosine) = sine.two(T::sin_cos_moderate::<R>);
        }
        (sines, cosines)
    }

    #[inline(always)]
    fn dispatch<W: Work<Self>>(work: W) -> W::Output {
        at_hand(work)
    }
}

/// The sines and cosines of angles of any size.
#[cold]
#[inline(never)]
fn one_by_one<R: Rounding, T: Lane, const L: usize, const N: usize>(
    angles: [Pack<T, L>; N],
) -> ([Pack<T, L>; N], [Pack<T, L>; N]) {
    let pairs = angles.map(|angle| angle.two(T::sin_cos_own::<R>));
    (pairs.map(|(sine, _)| sine), pairs.map(|(_, cosine)| cosine))
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::super::Scalar;
    use super::super::rounding::{Fused, OfTarget, Rounding, Unfused};
    use super::{Lane, Pack};
    use core::array::from_fn;

    const NUMBERS: [f64; 8] = [0.3, -0.0, f64::NAN, -1.7, f64::INFINITY, 1e9, -1e-310, 2.5];

    /// Every operation of the trait, on three numbers.
    fn results<R: Rounding, T: Scalar>(a: T, b: T, c: T) -> [T; 14] {
        let (sine, cosine) = a.sin_cos();
        let ([first, second], [third, _]) = T::sin_cos_all_by::<R, _>([a, b]);
        let third_of = a * T::constant(1.0 / 3.0);
        [
            a + b,
            a - b,
            a * b,
            a / b,
            -a,
            a.mul_add_by::<R>(b, c),
            a.sqrt(),
            sine,
            cosine,
            first,
            second,
            third,
            a.minus_sine(b),
            a.sign() + third_of,
        ]
    }

    fn every_lane_is_the_number_alone<R: Rounding, T: Lane + core::fmt::Debug>() {
        for shift in 0..NUMBERS.len() {
            let number = |lane: usize, step: usize| T::constant(NUMBERS[(lane * step + shift) % 8]);
            let pack = |step| Pack::<T, 8>(from_fn(|lane| number(lane, step)));
            let together = results::<R, _>(pack(1), pack(3), pack(5));
            for lane in 0..8 {
                let alone = results::<R, _>(number(lane, 1), number(lane, 3), number(lane, 5));
                for (together, alone) in together.iter().zip(alone) {
                    let found = together.0[lane];
                    // As text, since NaN is not equal to itself and the sign of zero counts.
                    assert_eq!(std::format!("{found:?}"), std::format!("{alone:?}"));
                }
            }
        }
    }

    #[test]
    fn every_lane_is_the_number_alone_whatever_the_others_are() {
        every_lane_is_the_number_alone::<Unfused, f64>();
        every_lane_is_the_number_alone::<Unfused, f32>();
        every_lane_is_the_number_alone::<Fused, f64>();
        every_lane_is_the_number_alone::<Fused, f32>();
    }

    #[test]
    fn sines_differ_by_the_rounding_of_their_products() {
        let angles = (0..1000).map(|i| 0.37 * f64::from(i));
        let differing = angles.filter(|angle| {
            let ([unfused], _) = f64::sin_cos_all_by::<Unfused, _>([*angle]);
            let ([fused], _) = f64::sin_cos_all_by::<Fused, _>([*angle]);
            let ([of_target], _) = f64::sin_cos_all([*angle]);
            assert!((fused - unfused).abs() <= f64::EPSILON);
            let expected = if OfTarget::FUSES { fused } else { unfused };
            assert_eq!(of_target.to_bits(), expected.to_bits());
            fused.to_bits() != unfused.to_bits()
        });
        assert!(differing.count() > 0);
    }
}
