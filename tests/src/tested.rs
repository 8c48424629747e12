//! Scalar types in which programs are tested.
//!
//! In: the operations of a program. Out: results as generated code has them with the runtime's own sines: IEEE 754 in
//! double and in single precision, with and without fused products, and single precision with subnormal numbers
//! flushed to zero, as on many processors. Each type gives the same bits on every machine.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use homogen_codegen::Real;
use homogen_codegen::expression::Arithmetic;

use crate::fused_sines;

/// A type whose errors are measured.
pub trait Tested: Arithmetic + Copy + Debug {
    /// Its name in tables.
    const NAME: &'static str;
    /// The type for which programs are generated.
    const REAL: Real;
    /// u, the largest relative error of an operation.
    const ROUNDOFF: f64;
    /// The smallest size for measures of error: an operation whose result underflows has an error of up to u times
    /// this.
    const FLOOR: f64;

    /// The exact value in `f64`.
    fn to_f64(self) -> f64;
}

/// Double precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct F64(pub f64);

/// Single precision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct F32(pub f32);

/// Single precision without subnormal numbers: arguments and results that are subnormal become zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flushed(pub(crate) f32);

/// Double precision with fused products: product and sum are rounded once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fused64(pub f64);

/// Single precision with fused products: product and sum are rounded once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fused32(pub f32);

impl Flushed {
    /// The number; zero if it is subnormal.
    #[must_use]
    pub const fn new(x: f32) -> Self {
        Self(if x.is_subnormal() {
            0.0_f32.copysign(x)
        } else {
            x
        })
    }
}

/// Implements the operations of a wrapped number.
macro_rules! implement {
    ($type:ident, $new:expr, $sin_cos:path $(, $mul_add:path)?) => {
        impl Add for $type {
            type Output = Self;

            fn add(self, other: Self) -> Self {
                $new(self.0 + other.0)
            }
        }

        impl Sub for $type {
            type Output = Self;

            fn sub(self, other: Self) -> Self {
                $new(self.0 - other.0)
            }
        }

        impl Mul for $type {
            type Output = Self;

            fn mul(self, other: Self) -> Self {
                $new(self.0 * other.0)
            }
        }

        impl Div for $type {
            type Output = Self;

            fn div(self, other: Self) -> Self {
                $new(self.0 / other.0)
            }
        }

        impl Neg for $type {
            type Output = Self;

            fn neg(self) -> Self {
                $new(-self.0)
            }
        }

        impl Arithmetic for $type {
            fn literal(value: f64) -> Self {
                $new(Arithmetic::literal(value))
            }

            $(fn mul_add(self, factor: Self, term: Self) -> Self {
                $new($mul_add(self.0, factor.0, term.0))
            })?

            fn sqrt(self) -> Self {
                $new(self.0.sqrt())
            }

            fn sign(self) -> Self {
                $new(Arithmetic::sign(self.0))
            }

            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = $sin_cos(self.0);
                ($new(sine), $new(cosine))
            }
        }
    };
}

implement!(F64, Self, fused_sines::double::unfused);
implement!(F32, Self, fused_sines::single::unfused);
implement!(Flushed, Self::new, fused_sines::single::unfused);
// Without the instruction, the standard library computes the same bits in software.
implement!(Fused64, Self, fused_sines::double::sin_cos, f64::mul_add);
implement!(Fused32, Self, fused_sines::single::sin_cos, f32::mul_add);

impl Tested for F64 {
    const NAME: &'static str = "f64";
    const REAL: Real = Real::F64;
    const ROUNDOFF: f64 = f64::EPSILON / 2.0;
    const FLOOR: f64 = f64::MIN_POSITIVE;

    fn to_f64(self) -> f64 {
        self.0
    }
}

impl Tested for F32 {
    const NAME: &'static str = "f32";
    const REAL: Real = Real::F32;
    // 2⁻²⁴ and 2⁻¹²⁶, for which `f64::from` is not const.
    const ROUNDOFF: f64 = 5.960_464_477_539_063e-8;
    const FLOOR: f64 = 1.175_494_350_822_287_5e-38;

    fn to_f64(self) -> f64 {
        self.0.into()
    }
}

impl Tested for Flushed {
    const NAME: &'static str = "flushed";
    const REAL: Real = Real::F32;
    const ROUNDOFF: f64 = F32::ROUNDOFF;
    // A subnormal result is lost entirely: 2⁻¹²⁶ / u.
    const FLOOR: f64 = F32::FLOOR / F32::ROUNDOFF;

    fn to_f64(self) -> f64 {
        self.0.into()
    }
}

impl Tested for Fused64 {
    const NAME: &'static str = "f64_fused";
    const REAL: Real = Real::F64;
    const ROUNDOFF: f64 = F64::ROUNDOFF;
    const FLOOR: f64 = F64::FLOOR;

    fn to_f64(self) -> f64 {
        self.0
    }
}

impl Tested for Fused32 {
    const NAME: &'static str = "f32_fused";
    const REAL: Real = Real::F32;
    const ROUNDOFF: f64 = F32::ROUNDOFF;
    const FLOOR: f64 = F32::FLOOR;

    fn to_f64(self) -> f64 {
        self.0.into()
    }
}

#[cfg(test)]
mod tests {
    use homogen_codegen::expression::Arithmetic;

    use super::{F32, F64, Flushed, Fused32, Fused64, Tested};

    #[test]
    fn the_constants_are_those_of_the_types() {
        assert_eq!(F64::ROUNDOFF, 2_f64.powi(-53));
        assert_eq!(F32::ROUNDOFF, 2_f64.powi(-24));
        assert_eq!(F32::FLOOR, f64::from(f32::MIN_POSITIVE));
        assert_eq!(Flushed::FLOOR, 2_f64.powi(-102));
    }

    #[test]
    fn subnormal_arguments_and_results_are_flushed() {
        let smallest = Flushed::literal(f32::MIN_POSITIVE.into());
        let half = Flushed::literal(0.5);
        let nothing = [
            Flushed::literal(1e-40),
            Flushed::new(-1e-40),
            smallest * half,
            smallest / Flushed::literal(2.0),
            smallest * Flushed::literal(1.5) - smallest,
        ];
        assert!(nothing.iter().all(|x| x.to_f64() == 0.0), "{nothing:?}");
        assert_eq!(smallest.to_f64(), F32::FLOOR);
        assert_ne!((F32::literal(1e-40) * F32::literal(0.5)).to_f64(), 0.0);
    }

    /// (1 + ε)(1 − ε) − 1 = −ε²; 0 if the product is rounded before the sum.
    fn product_near_one<T: Tested>(epsilon: f64) -> f64 {
        let [one, epsilon] = [1.0, epsilon].map(T::literal);
        (one + epsilon).mul_add(one - epsilon, -one).to_f64()
    }

    #[test]
    fn product_and_sum_are_rounded_once_only_if_fused() {
        let (double, single) = (f64::EPSILON, f64::from(f32::EPSILON));
        assert_eq!(product_near_one::<Fused64>(double), -double * double);
        assert_eq!(product_near_one::<Fused32>(single), -single * single);
        assert_eq!(product_near_one::<F64>(double), 0.0);
        assert_eq!(product_near_one::<F32>(single), 0.0);
        assert_eq!(product_near_one::<Flushed>(single), 0.0);
    }
}
