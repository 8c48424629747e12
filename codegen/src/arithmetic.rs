//! Arithmetic of generated code with its own sines: `f32` and `f64`, without fused operations.
//!
//! In: a number. Out: the results of a file for `core` alone, of C or of a Python package, bit for bit, up to the
//! maximum angle of their sines; beyond, those of the platform. The engine's own results do not depend on it.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::expression::Arithmetic;
use crate::real::{Real, Trigonometry};

/// Number with the sines of generated code.
#[derive(Clone, Copy, Debug)]
pub struct OwnSines<T>(T);

mod double {
    include!("print/rust/sines/double.rs");

    pub(super) fn own(angle: f64) -> (f64, f64) {
        sin_cos(angle)
    }
}

mod single {
    include!("print/rust/sines/single.rs");

    pub(super) fn own(angle: f32) -> (f32, f32) {
        sin_cos(angle)
    }
}

macro_rules! operator {
    ($float:ident: $($name:ident $method:ident)*) => {$(
        impl $name for OwnSines<$float> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

macro_rules! arithmetic {
    ($float:ident, $real:ident, $sines:ident) => {
        operator!($float: Add add Sub sub Mul mul Div div);

        impl Neg for OwnSines<$float> {
            type Output = Self;

            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl Arithmetic for OwnSines<$float> {
            fn literal(value: f64) -> Self {
                Self($float::literal(value))
            }

            fn sqrt(self) -> Self {
                Self(Arithmetic::sqrt(self.0))
            }

            fn sign(self) -> Self {
                Self(Arithmetic::sign(self.0))
            }

            fn sin_cos(self) -> (Self, Self) {
                let reach = Trigonometry::Own.reach(Real::$real);
                let (sine, cosine) = if f64::from(self.0).abs() <= reach {
                    $sines::own(self.0)
                } else {
                    Arithmetic::sin_cos(self.0)
                };
                (Self(sine), Self(cosine))
            }
        }

        impl From<OwnSines<$float>> for f64 {
            fn from(number: OwnSines<$float>) -> Self {
                number.0.into()
            }
        }
    };
}
arithmetic!(f32, F32, single);
arithmetic!(f64, F64, double);
