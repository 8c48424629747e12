//! Where a number of a program lies, and how far rounding may have taken it from there.
//!
//! In: operands. Out: the same for the result of an operation, second-order terms of the error
//! included. The rounding of these computations themselves is not followed: [`SLACK`] covers
//! it.

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::expression::Double;
use crate::real::Real;

/// What the bounds are multiplied by for their own rounding, which they do not follow: more than
/// some million operations of `f64` on positive numbers can lose.
pub const SLACK: f64 = 1.0 + 1e-9;

/// The exact value is within [`lo`, `hi`], and the computed one within `error` of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// The least that the exact value can be.
    pub lo: f64,
    /// The greatest that it can be.
    pub hi: f64,
    /// The greatest distance of the computed value from the exact one.
    pub error: f64,
}

impl Value {
    /// Anything at all.
    pub const UNKNOWN: Self = Self {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
        error: f64::INFINITY,
    };

    /// A number between two others, free of error.
    #[must_use]
    pub const fn between(lo: f64, hi: f64) -> Self {
        Self { lo, hi, error: 0.0 }
    }

    /// The greatest magnitude that the exact value can have.
    pub(super) const fn size(self) -> f64 {
        self.lo.abs().max(self.hi.abs())
    }

    /// The greatest magnitude that the computed value can have.
    pub(crate) const fn reach(self) -> f64 {
        self.size() + self.error
    }

    /// After one more rounding. A result below the normal numbers is rounded to their spacing, or,
    /// where a processor does not have such numbers, taken for zero: the loss is less than the
    /// smallest normal number in both cases.
    pub(crate) fn rounded(self, scalar: Real) -> Self {
        Self {
            error: self.error + scalar.roundoff() * self.reach() + scalar.smallest(),
            ..self
        }
        .or_unknown()
    }

    /// As an operation reads it: where a processor does not have subnormal numbers, they are zero.
    pub(super) fn read(self, scalar: Real) -> Self {
        Self {
            error: self.error + scalar.smallest(),
            ..self
        }
    }

    /// Whether the type has a number of that size.
    pub(super) fn fits(self, scalar: Real) -> bool {
        self.reach() * SLACK < scalar.largest()
    }

    /// With what is known from elsewhere.
    pub(super) const fn within(self, size: f64, error: f64) -> Self {
        Self {
            lo: self.lo.max(-size),
            hi: self.hi.min(size),
            error: self.error.min(error),
        }
    }

    /// With a range that the exact value is known to keep.
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

    /// a + b, not yet rounded.
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

    /// a b, not yet rounded.
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

    /// a², not yet rounded.
    pub(super) fn squared(self) -> Self {
        let square = self.times(self);
        Self {
            lo: square.lo.max(0.0),
            ..square
        }
    }

    /// 1/a, not yet rounded; unknown where what is computed for a may be zero.
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

    /// √a, not yet rounded; unknown where what is computed for a may be negative.
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

    /// The sign of a: of an argument that of what is read, which is zero where it is subnormal and the
    /// processor has no such numbers.
    pub(super) fn sign(self, scalar: Real) -> Self {
        let of = |x: f64| f64::from(i8::from(x > 0.0) - i8::from(x < 0.0));
        let error = if self.error <= scalar.smallest() {
            0.0
        } else {
            // Within its error a number may be on the other side of zero.
            of(self.hi + self.error) - of(self.lo - self.error)
        };
        Self {
            error,
            ..Self::between(of(self.lo), of(self.hi))
        }
        .or_unknown()
    }

    /// sin a, within one unit in the last place.
    pub(super) fn sine(self, scalar: Real) -> Self {
        // What is lost in reducing an angle of many turns may be more than the margin.
        if self.size() > REDUCED {
            return Self::between(-1.0, 1.0).of_place(self.error, scalar);
        }
        // One of these quarter turns, and then every whole one, leads to an end of the range.
        let passes = |quarter: f64| {
            let turns = ((self.lo - MARGIN) / TAU - quarter).ceil();
            (turns + quarter) * TAU <= self.hi + MARGIN
        };
        // Not the platform's sine: what is printed is the same everywhere.
        let sine = |angle: f64| Double::from(angle).sin_cos().0.to_f64();
        let (from, to) = (sine(self.lo), sine(self.hi));
        let lo = if passes(0.75) { -1.0 } else { from.min(to) };
        let hi = if passes(0.25) { 1.0 } else { from.max(to) };
        let exact = Self::between((lo - MARGIN).max(-1.0), (hi + MARGIN).min(1.0));
        exact.of_place(self.error, scalar)
    }

    /// A sine of an angle that is off by so much.
    fn of_place(self, error: f64, scalar: Real) -> Self {
        // A unit in the last place is at most 2u of a number, and u below 1. Of what is subnormal
        // both the angle and its sine may be taken for zero.
        let place = scalar.roundoff() * (2.0 * (self.size() + error)).min(1.0);
        Self {
            error: error + place + 2.0 * scalar.smallest(),
            ..self
        }
        .or_unknown()
    }

    /// cos a, within one unit in the last place.
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

    /// Infinity times zero, or infinity less infinity, tells nothing.
    const fn or_unknown(self) -> Self {
        if self.lo.is_nan() || self.hi.is_nan() || self.error.is_nan() {
            Self::UNKNOWN
        } else {
            self
        }
    }
}

/// More than what is lost in reducing an angle of up to [`REDUCED`].
const MARGIN: f64 = 1e-13;

/// Beyond this angle \[rad\] sines are taken to be anything.
const REDUCED: f64 = 100.0;
