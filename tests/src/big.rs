//! Floating-point numbers of 256 bits, the reference for errors.
//!
//! In: numbers of `f64`, exactly. Out: results rounded to 256 bits by every operation, so that the loss of thousands
//! of operations is negligible beside that of the types under test. Only [`Big::to_f64`] rounds to `f64`.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

use dashu_float::FBig;
use dashu_float::ops::Abs;
use dashu_float::round::mode::HalfEven;
use homogen_codegen::expression::Arithmetic;

/// Bits of every number.
pub const BITS: usize = 256;

/// A number of [`BITS`] bits.
#[derive(Clone, PartialEq, PartialOrd)]
pub struct Big(FBig<HalfEven>);

impl Big {
    /// The exact value of `x`.
    ///
    /// # Panics
    /// If `x` is infinite or NaN.
    #[must_use]
    pub fn new(x: f64) -> Self {
        let exact = FBig::try_from(x).expect("the number is finite");
        Self(exact.with_precision(BITS).value())
    }

    /// 0.
    #[must_use]
    pub fn zero() -> Self {
        Self::new(0.0)
    }

    /// 1.
    #[must_use]
    pub fn one() -> Self {
        Self::new(1.0)
    }

    /// π.
    #[must_use]
    pub fn pi() -> Self {
        Self(FBig::<HalfEven>::pi(BITS))
    }

    /// √x.
    #[must_use]
    pub fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }

    /// |x|.
    #[must_use]
    pub fn abs(&self) -> Self {
        Self(self.0.clone().abs())
    }

    /// Sine and cosine.
    #[must_use]
    pub fn sin_cos(&self) -> (Self, Self) {
        let (sine, cosine) = self.0.sin_cos();
        (Self(sine), Self(cosine))
    }

    /// The angle of the point (`x`, `self`) from the x axis, in (−π, π]; 0 for the origin.
    #[must_use]
    pub fn atan2(&self, x: &Self) -> Self {
        let origin = [self, x].iter().all(|entry| **entry == Self::zero());
        if origin {
            Self::zero()
        } else {
            Self(self.0.atan2(&x.0))
        }
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.0.to_f64().value()
    }

    /// The larger of two numbers.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if self.partial_cmp(&other) == Some(Ordering::Less) {
            other
        } else {
            self
        }
    }
}

impl fmt::Debug for Big {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{:e}", self.to_f64())
    }
}

impl Neg for Big {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Neg for &Big {
    type Output = Big;

    fn neg(self) -> Big {
        Big(-&self.0)
    }
}

/// Implements an operation of two numbers, by value and by reference.
macro_rules! operation {
    ($operation:ident, $method:ident) => {
        impl $operation<&Big> for &Big {
            type Output = Big;

            fn $method(self, other: &Big) -> Big {
                Big($operation::$method(&self.0, &other.0))
            }
        }

        impl $operation<Big> for &Big {
            type Output = Big;

            fn $method(self, other: Big) -> Big {
                $operation::$method(self, &other)
            }
        }

        impl $operation<&Big> for Big {
            type Output = Big;

            fn $method(self, other: &Big) -> Big {
                $operation::$method(&self, other)
            }
        }

        impl $operation for Big {
            type Output = Big;

            fn $method(self, other: Big) -> Big {
                $operation::$method(&self, &other)
            }
        }
    };
}

operation!(Add, add);
operation!(Sub, sub);
operation!(Mul, mul);
operation!(Div, div);

impl Arithmetic for Big {
    fn literal(value: f64) -> Self {
        Self::new(value)
    }

    fn sqrt(self) -> Self {
        Self::sqrt(&self)
    }

    fn sign(self) -> Self {
        let sign = |x: f64| f64::from(i8::from(x > 0.0) - i8::from(x < 0.0));
        Self::new(sign(self.to_f64()))
    }

    fn sin_cos(self) -> (Self, Self) {
        Self::sin_cos(&self)
    }
}

#[cfg(test)]
mod tests {
    use super::Big;

    /// The identities hold to nearly 256 bits; in `f64` they would hold to 53.
    #[test]
    fn every_operation_carries_all_bits() {
        let small = Big::new(2_f64.powi(-240));
        let [tenth, seventh] = [10.0, 7.0].map(|x| Big::one() / Big::new(x));
        let (sine, cosine) = tenth.sin_cos();
        for (found, expected) in [
            (&tenth * Big::new(10.0), Big::one()),
            (seventh.sqrt() * seventh.sqrt(), seventh.clone()),
            (&sine * &sine + &cosine * &cosine, Big::one()),
            (sine.atan2(&cosine), tenth.clone()),
            (Big::zero().atan2(&-Big::one()), Big::pi()),
            (Big::zero().atan2(&Big::zero()), Big::zero()),
            (&tenth - &seventh + &seventh, tenth.clone()),
            ((-&tenth).abs().max(-seventh), tenth),
        ] {
            assert!((&found - &expected).abs() < small, "{found:?} {expected:?}");
        }
        assert_eq!(Big::one() + &small - Big::one(), small);
    }

    #[test]
    fn zero_is_an_operand_like_any_other() {
        let sum = Big::zero() + Big::new(3.0) * Big::zero() - Big::new(-2.0);
        assert_eq!(sum.to_f64(), 2.0);
        assert_eq!(Big::zero().sin_cos().1.to_f64(), 1.0);
    }
}
