//! Range and error of a value.
//!
//! In: operands. Out: range and error of the result of an operation, with second-order terms. The rounding errors of
//! these computations are not tracked; [`SLACK`] covers them.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::expression::Double;
use crate::real::Real;

/// Factor on bounds for the rounding errors of their computation: more than millions of operations on positive numbers
/// in `f64` can lose.
pub const SLACK: f64 = 1.0 + 1e-9;

/// Exact value within [`lo`, `hi`], computed value within `error` of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// Minimum of the exact value.
    pub lo: f64,
    /// Maximum of the exact value.
    pub hi: f64,
    /// Maximum distance of the computed value from the exact one.
    pub error: f64,
}

impl Value {
    /// Any value.
    pub const UNKNOWN: Self = Self {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
        error: f64::INFINITY,
    };

    /// An exact number between two others.
    #[must_use]
    pub const fn between(lo: f64, hi: f64) -> Self {
        Self { lo, hi, error: 0.0 }
    }

    /// Maximum magnitude of the exact value.
    pub(super) const fn size(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// Maximum magnitude of the computed value.
    pub(crate) const fn reach(self) -> f64 {
        self.size() + self.error
    }

    /// Adds one rounding. A subnormal result is rounded to the spacing of subnormal numbers or flushed to zero,
    /// depending on the processor; the loss is below the smallest normal number in both cases.
    pub(crate) fn rounded(self, scalar: Real) -> Self {
        Self {
            error: self.error + scalar.roundoff() * self.reach() + scalar.smallest(),
            ..self
        }
        .or_unknown()
    }

    /// Value that an operation reads: some processors flush subnormal operands to zero.
    pub(super) fn read(self, scalar: Real) -> Self {
        Self {
            error: self.error + scalar.smallest(),
            ..self
        }
    }

    /// True if the type has numbers of this magnitude.
    pub(super) fn fits(self, scalar: Real) -> bool {
        self.reach() * SLACK < scalar.largest()
    }

    /// Limits magnitude and error to known bounds.
    pub(super) const fn within(self, size: f64, error: f64) -> Self {
        Self {
            lo: self.lo.max(-size),
            hi: self.hi.min(size),
            error: self.error.min(error),
        }
    }

    /// Limits the exact value to a known range.
    pub(super) const fn kept(self, range: Option<[f64; 2]>) -> Self {
        match range {
            Some([lo, hi]) => Self {
                lo: self.lo.max(lo),
                hi: self.hi.min(hi),
                ..self
            },
            None => self,
        }
    }

    /// a + b before rounding.
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            lo: self.lo + other.lo,
            hi: self.hi + other.hi,
            error: self.error + other.error,
        }
        .or_unknown()
    }

    /// −a.
    pub(super) const fn opposite(self) -> Self {
        Self {
            lo: -self.hi,
            hi: -self.lo,
            error: self.error,
        }
    }

    /// a b before rounding.
    pub(super) fn times(self, other: Self) -> Self {
        let ends = [
            self.lo * other.lo,
            self.lo * other.hi,
            self.hi * other.lo,
            self.hi * other.hi,
        ];
        Self {
            error: self.size() * other.error + self.error * other.reach(),
            ..Self::around(ends)
        }
        .or_unknown()
    }

    /// a² before rounding.
    pub(super) fn squared(self) -> Self {
        let square = self.times(self);
        Self {
            lo: square.lo.max(0.0),
            ..square
        }
    }

    /// 1/a before rounding; unknown if the computed a may be zero.
    pub(super) fn reciprocal(self) -> Self {
        let least = self.lo.max(-self.hi);
        let computed = least - self.error;
        if computed <= 0.0 {
            return Self::UNKNOWN;
        }
        let ends = [1.0 / self.lo, 1.0 / self.hi];
        Self {
            error: self.error / (least * computed),
            ..Self::around(ends)
        }
        .or_unknown()
    }

    /// √a before rounding; unknown if the computed a may be negative.
    pub(super) fn root(self) -> Self {
        let least = self.lo - self.error;
        if least <= 0.0 {
            return Self::UNKNOWN;
        }
        Self {
            lo: self.lo.sqrt(),
            hi: self.hi.sqrt(),
            error: self.error / (2.0 * least.sqrt()),
        }
        .or_unknown()
    }

    /// Sign of a. For an argument, the sign of the value as read: zero if it is subnormal and the processor flushes it.
    pub(super) fn sign(self, scalar: Real) -> Self {
        let of = |x: f64| f64::from(i8::from(x > 0.0) - i8::from(x < 0.0));
        let error = if self.error <= scalar.smallest() {
            0.0
        } else {
            // Within its error a number may have the other sign.
            of(self.hi + self.error) - of(self.lo - self.error)
        };
        Self {
            error,
            ..Self::between(of(self.lo), of(self.hi))
        }
        .or_unknown()
    }

    /// sin a, within one ulp.
    pub(super) fn sine(self, scalar: Real) -> Self {
        // The error of reducing a large angle may exceed the margin.
        if self.size() > REDUCED {
            return Self::between(-1.0, 1.0).of_place(self.error, scalar);
        }
        // These quarter turns, modulo whole turns, are extrema of the sine within the range.
        let passes = |quarter: f64| {
            let turns = ((self.lo - MARGIN) / TAU - quarter).ceil();
            (turns + quarter) * TAU <= self.hi + MARGIN
        };
        // Not the platform's sine, so that printed bounds are the same on every platform.
        let sine = |angle: f64| Double::from(angle).sin_cos().0.to_f64();
        let (from, to) = (sine(self.lo), sine(self.hi));
        let lo = if passes(0.75) { -1.0 } else { from.min(to) };
        let hi = if passes(0.25) { 1.0 } else { from.max(to) };
        let exact = Self::between((lo - MARGIN).max(-1.0), (hi + MARGIN).min(1.0));
        exact.of_place(self.error, scalar)
    }

    /// Adds the error of a sine whose angle has this error.
    fn of_place(self, error: f64, scalar: Real) -> Self {
        // One ulp is at most 2u of a number, and at most u below 1. A subnormal angle and its sine may both be flushed
        // to zero.
        let place = scalar.roundoff() * (2.0 * (self.size() + error)).min(1.0);
        Self {
            error: error + place + 2.0 * scalar.smallest(),
            ..self
        }
        .or_unknown()
    }

    /// cos a, within one ulp.
    pub(super) fn cosine(self, scalar: Real) -> Self {
        let turned = Self {
            lo: self.lo + FRAC_PI_2,
            hi: self.hi + FRAC_PI_2,
            ..self
        };
        turned.sine(scalar)
    }

    fn around(ends: impl IntoIterator<Item = f64> + Copy) -> Self {
        let lo = ends.into_iter().fold(f64::INFINITY, f64::min);
        let hi = ends.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let unknown = ends.into_iter().any(f64::is_nan);
        if unknown {
            Self::UNKNOWN
        } else {
            Self::between(lo, hi)
        }
    }

    /// Unknown instead of NaN, which infinity times zero and infinity minus infinity give.
    pub(super) const fn or_unknown(self) -> Self {
        if self.lo.is_nan() || self.hi.is_nan() || self.error.is_nan() {
            Self::UNKNOWN
        } else {
            self
        }
    }
}

/// Larger than the error of reducing an angle of up to [`REDUCED`].
const MARGIN: f64 = 1e-13;

/// Maximum angle \[rad\] whose sine is bounded by its range; beyond, it is between −1 and 1.
const REDUCED: f64 = 100.0;
