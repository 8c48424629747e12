//! Numbers of several states, for which a program runs at once.
//!
//! In: an arithmetic. Out: the same for a number of each state, with the same bits: each operation is looked up once and
//! done for all states before the next one.

use std::array::from_fn;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::expression::Arithmetic;

/// Number of states for which each operation is done before the next one.
pub const LANES: usize = 8;

/// A number for each of several states.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<T>(pub [T; LANES]);

impl<T: Copy> Lanes<T> {
    fn with(self, other: Self, operation: impl Fn(T, T) -> T) -> Self {
        Self(from_fn(|lane| operation(self.0[lane], other.0[lane])))
    }
}

macro_rules! operator {
    ($($name:ident $method:ident)*) => {$(
        impl<T: $name<Output = T> + Copy> $name for Lanes<T> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                self.with(other, $name::$method)
            }
        }
    )*};
}
operator!(Add add Sub sub Mul mul Div div);

impl<T: Neg<Output = T>> Neg for Lanes<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(Neg::neg))
    }
}

impl<T: Arithmetic + Copy> Arithmetic for Lanes<T> {
    fn literal(value: f64) -> Self {
        Self([T::literal(value); LANES])
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        Self(from_fn(|lane| {
            self.0[lane].mul_add(factor.0[lane], term.0[lane])
        }))
    }

    fn sqrt(self) -> Self {
        Self(self.0.map(Arithmetic::sqrt))
    }

    fn sign(self) -> Self {
        Self(self.0.map(Arithmetic::sign))
    }

    fn sin_cos(self) -> (Self, Self) {
        let turned = self.0.map(Arithmetic::sin_cos);
        (
            Self(turned.map(|(sine, _)| sine)),
            Self(turned.map(|(_, cosine)| cosine)),
        )
    }
}
