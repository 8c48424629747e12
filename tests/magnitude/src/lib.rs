//! A number that knows how large it could be if nothing cancelled.
//!
//! In: the operations of a program, of a generated function or of the library. Out: beside each value
//! S, the same operations on absolute values: what the roundings of a sum are proportional to, even
//! where the sum is nearly zero. Values are as exact as the one who measures needs them.

use core::fmt::Debug;
use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};

use homogen::Scalar;
use homogen_codegen::expression::Arithmetic;

/// Whom sizes are measured for.
pub trait Measure: Copy + Debug {
    /// What values are computed in.
    type Value: Arithmetic + Copy + Debug;
    /// No size is smaller.
    const FLOOR: f64;

    /// The number nearest to a value.
    fn nearest(value: Self::Value) -> f64;
}

/// For every type, as long as nothing underflows. For sizes alone, values of `f64` are enough.
impl Measure for f64 {
    type Value = Self;
    const FLOOR: f64 = 0.0;

    fn nearest(value: Self) -> f64 {
        value
    }
}

/// A value and its size without cancellation.
#[derive(Clone, Copy, Debug)]
pub struct Magnitude<M: Measure> {
    value: M::Value,
    size: f64,
    /// Whether it is an argument or a literal, and so not off by anything.
    given: bool,
    of: PhantomData<M>,
}

impl<M: Measure> Magnitude<M> {
    /// An argument, or a literal.
    #[must_use]
    pub fn given(value: f64) -> Self {
        Self {
            given: true,
            ..Self::new(M::Value::literal(value), value.abs())
        }
    }

    fn new(value: M::Value, size: f64) -> Self {
        Self {
            value,
            size: size.max(M::FLOOR),
            given: false,
            of: PhantomData,
        }
    }

    /// The value.
    #[must_use]
    pub const fn value(self) -> M::Value {
        self.value
    }

    /// S: a result is off by a small multiple of u S.
    #[must_use]
    pub const fn size(self) -> f64 {
        self.size
    }
}

impl<M: Measure> Add for Magnitude<M> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.size + other.size)
    }
}

impl<M: Measure> Sub for Magnitude<M> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.size + other.size)
    }
}

impl<M: Measure> Mul for Magnitude<M> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.size * other.size)
    }
}

/// |a| / |b| with what b is: its own size without cancellation would only make the quotient small.
impl<M: Measure> Div for Magnitude<M> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let divisor = M::nearest(other.value).abs();
        Self::new(self.value / other.value, self.size / divisor)
    }
}

impl<M: Measure> Neg for Magnitude<M> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl<M: Measure> Arithmetic for Magnitude<M> {
    fn literal(value: f64) -> Self {
        Self::given(value)
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.size / M::nearest(root))
    }

    /// Exactly that of what was computed.
    fn sign(self) -> Self {
        let sign = M::nearest(self.value.sign());
        Self::new(M::Value::literal(sign), sign.abs())
    }

    /// |sin x| and |cos x| of an angle that is given. One that was computed is off by u S, and
    /// turns its sine by |cos x| times that.
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        let turn = if self.given { 0.0 } else { self.size };
        let of = |value: M::Value, slope: M::Value| {
            let [size, slope] = [value, slope].map(|x| M::nearest(x).abs());
            Self::new(value, size + slope * turn)
        };
        (of(sine, cosine), of(cosine, sine))
    }
}

impl<M: Measure> Scalar for Magnitude<M> {
    fn constant(value: f64) -> Self {
        Self::given(value)
    }

    fn mul_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }

    fn sqrt(self) -> Self {
        Arithmetic::sqrt(self)
    }

    fn sign(self) -> Self {
        Arithmetic::sign(self)
    }

    fn sin_cos(self) -> (Self, Self) {
        Arithmetic::sin_cos(self)
    }
}

#[cfg(test)]
mod tests {
    use homogen::Scalar;

    use super::{Magnitude, Measure};

    /// Whoever loses what is smaller than 1e-9.
    #[derive(Clone, Copy, Debug)]
    struct Coarse;

    impl Measure for Coarse {
        type Value = f64;
        const FLOOR: f64 = 1e-9;

        fn nearest(value: f64) -> f64 {
            value
        }
    }

    fn given(x: f64) -> Magnitude<f64> {
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
        assert_eq!(Magnitude::<Coarse>::given(0.0).size(), 1e-9);
        let tiny = Magnitude::<Coarse>::given(1e-30);
        assert_eq!((tiny * tiny).size(), 1e-9);
        assert!((given(1e-30) * given(1e-30)).size() < 1e-59);
    }
}
