//! A scalar that also carries the size that its terms have without cancellation.
//!
//! In: the operations of a generated function or of the library. Out: each value and S, the result of
//! the same operations on absolute values. Rounding errors of a sum are proportional to S, even where
//! the sum is nearly zero. The caller chooses the type of the values.

use core::fmt::Debug;
use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};

use homogen::Scalar;
use homogen_codegen::expression::Arithmetic;

/// The setting of a measurement: the type of values, and the smallest size.
pub trait Measure: Copy + Debug {
    /// The type in which values are computed.
    type Value: Arithmetic + Copy + Debug;
    /// The smallest size.
    const FLOOR: f64;

    /// The nearest `f64`.
    fn nearest(value: Self::Value) -> f64;
}

/// Values in `f64`, enough where only sizes are needed. Any type may be measured as long as nothing underflows.
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
    /// True for arguments and literals, which have no error.
    is_exact: bool,
    of: PhantomData<M>,
}

impl<M: Measure> Magnitude<M> {
    /// An argument, or a literal.
    #[must_use]
    pub fn given(value: f64) -> Self {
        Self {
            is_exact: true,
            ..Self::new(M::Value::literal(value), value.abs())
        }
    }

    fn new(value: M::Value, size: f64) -> Self {
        Self {
            value,
            size: size.max(M::FLOOR),
            is_exact: false,
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

/// |a| / |b|, with the value of b: its size without cancellation would make the quotient too small.
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

    /// The sign of the computed value, without error.
    fn sign(self) -> Self {
        let sign = M::nearest(self.value.sign());
        Self::new(M::Value::literal(sign), sign.abs())
    }

    /// Sizes of the sine and cosine. An exact angle gives |sin x| and |cos x|; a computed one has an error of u S,
    /// which changes its sine by |cos x| times that.
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        let error = if self.is_exact { 0.0 } else { self.size };
        let of = |value: M::Value, slope: M::Value| {
            let [size, slope] = [value, slope].map(|x| M::nearest(x).abs());
            Self::new(value, size + slope * error)
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

    /// A type that loses everything below 1e-9.
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
    fn a_cancelled_difference_keeps_its_size() {
        let difference = (given(3.0) - given(3.0)) * given(-2.0);
        assert_eq!((difference.value, difference.size()), (0.0, 12.0));
        assert_eq!((given(6.0) / (given(3.0) - given(1.0))).size(), 3.0);
        assert_eq!((-given(-4.0)).sqrt().size(), 2.0);
    }

    #[test]
    fn the_sine_of_a_computed_angle_has_the_size_of_the_angle() {
        let big = given(1e6);
        assert!((big - given(1e6)).sin_cos().0.size() >= 2e6);
        assert!(big.sin_cos().0.size() <= 1.0);
    }

    #[test]
    fn no_size_is_below_the_floor() {
        assert_eq!(Magnitude::<Coarse>::given(0.0).size(), 1e-9);
        let tiny = Magnitude::<Coarse>::given(1e-30);
        assert_eq!((tiny * tiny).size(), 1e-9);
        assert!((given(1e-30) * given(1e-30)).size() < 1e-59);
    }
}
