//! A number that knows how large it could be if nothing cancelled.
//!
//! In: the operations of a program. Out: beside each value S, the same operations on absolute values:
//! what the roundings of a sum are proportional to, even where the sum is nearly zero. Values are
//! of `f64`, which is enough for a measure.

use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};

use homogen_codegen::expression::Arithmetic;

use crate::tested::Tested;

/// A value and its size without cancellation, as a type of number sees it: no size is below that
/// type's floor, since what underflows is off by that.
#[derive(Clone, Copy, Debug)]
pub struct Magnitude<T> {
    value: f64,
    size: f64,
    /// Whether it is an argument or a literal, and so not off by anything.
    given: bool,
    of: PhantomData<T>,
}

impl<T: Tested> Magnitude<T> {
    /// An argument, or a literal.
    #[must_use]
    pub fn given(value: f64) -> Self {
        Self {
            given: true,
            ..Self::new(value, value.abs())
        }
    }

    fn new(value: f64, size: f64) -> Self {
        Self {
            value,
            size: size.max(T::FLOOR),
            given: false,
            of: PhantomData,
        }
    }

    /// S: a result is off by a small multiple of u S.
    #[must_use]
    pub const fn size(self) -> f64 {
        self.size
    }
}

impl<T: Tested> Add for Magnitude<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.size + other.size)
    }
}

impl<T: Tested> Sub for Magnitude<T> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.size + other.size)
    }
}

impl<T: Tested> Mul for Magnitude<T> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.size * other.size)
    }
}

/// |a| / |b| with what b is: its own size without cancellation would only make the quotient small.
impl<T: Tested> Div for Magnitude<T> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self::new(self.value / other.value, self.size / other.value.abs())
    }
}

impl<T: Tested> Neg for Magnitude<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl<T: Tested> Arithmetic for Magnitude<T> {
    fn literal(value: f64) -> Self {
        Self::given(value)
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.size / root)
    }

    /// |sin x| and |cos x| of an angle that is given. One that was computed is off by u S, and
    /// turns its sine by |cos x| times that.
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        let turn = if self.given { 0.0 } else { self.size };
        let of = |value: f64, slope: f64| Self::new(value, value.abs() + slope.abs() * turn);
        (of(sine, cosine), of(cosine, sine))
    }
}

#[cfg(test)]
mod tests {
    use homogen_codegen::expression::Arithmetic;

    use super::Magnitude;
    use crate::tested::{F32, F64, Flushed, Tested};

    fn given(x: f64) -> Magnitude<F64> {
        Magnitude::given(x)
    }

    #[test]
    fn what_cancels_keeps_its_size() {
        let difference = (given(3.0) - given(3.0)) * given(-2.0);
        assert_eq!((difference.value, difference.size()), (0.0, 12.0));
        assert_eq!((given(6.0) / (given(3.0) - given(1.0))).size(), 3.0);
        assert_eq!((-given(-4.0)).sqrt().size(), 2.0);
    }

    #[test]
    fn a_summed_angle_is_off_by_what_its_sum_is() {
        let big = given(1e6);
        assert!((big - given(1e6)).sin_cos().0.size() >= 2e6);
        assert!(big.sin_cos().0.size() <= 1.0);
    }

    #[test]
    fn nothing_is_smaller_than_what_underflow_loses() {
        assert_eq!(Magnitude::<F32>::given(0.0).size(), F32::FLOOR);
        let tiny = Magnitude::<Flushed>::given(1e-30);
        assert_eq!((tiny * tiny).size(), Flushed::FLOOR);
    }
}
