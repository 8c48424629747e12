//! Values of a program up to the current step.
//!
//! In: conditions, and the first steps of a program. Out: range and error of each operand that a later step may read.

use super::kind::{ColumnKind, Follows, Monomial, StepForm};
use super::quaternion::{Polynomials, RotationEntry, beyond};
use super::reason::Reason;
use super::rotation::{PlaneRotations, SineOrCosine};
use super::value::Value;
use crate::expression::Input;
use crate::real::Real;
use crate::schedule::{Operand, Program};

/// Conditions for the bounds of a program.
pub struct Conditions<'c> {
    /// Scalar type; `f64` for generic code.
    pub scalar: Real,
    /// Maximum magnitude of an angle \[rad\] whose sine and cosine are within one ulp.
    pub angles: f64,
    /// Range and error of each input.
    pub range: &'c dyn Fn(Input) -> Value,
    /// First entries x of quaternions x, y, z, w, which have length 1 up to rounding.
    pub quaternions: &'c [Input],
}

/// Values up to the current step.
pub struct Known<'p> {
    pub program: &'p Program,
    pub conditions: &'p Conditions<'p>,
    /// Sines and cosines.
    pub turns: PlaneRotations,
    /// Polynomials in the entries of quaternions.
    pub polynomials: Polynomials,
    pub steps: Vec<Computed>,
}

/// Value of a step.
#[derive(Clone, Copy)]
pub struct Computed {
    pub value: Value,
    pub form: StepForm,
    pub reason: Option<Reason>,
    /// Rotation whose sine or cosine it is.
    pub place: Option<SineOrCosine>,
    pub follows: Follows,
    pub kind: ColumnKind,
    /// Entry of the rotation matrix of a quaternion that it is.
    pub entry: Option<RotationEntry>,
}

impl Known<'_> {
    pub const fn scalar(&self) -> Real {
        self.conditions.scalar
    }

    /// Range and error of an operand.
    pub fn value(&self, operand: Operand) -> Value {
        match operand {
            Operand::Literal(_) | Operand::Input(_) => {
                let value = self.given(operand);
                if value.fits(self.scalar()) {
                    value
                } else {
                    Value::UNKNOWN
                }
            }
            Operand::Sin(k) => self.turns.sine(k),
            Operand::Cos(k) => self.turns.cosine(k),
            Operand::Step(k) => self.steps[k as usize].value,
        }
    }

    /// Range and error of a literal or an input.
    pub fn given(&self, operand: Operand) -> Value {
        match operand {
            Operand::Literal(number) => {
                let open = self.program.open.get(&number.abs().to_bits());
                literal(number, open.copied().unwrap_or(0.0), self.scalar())
            }
            Operand::Input(input) => {
                let range = (self.conditions.range)(input);
                let beyond = beyond(input, self.conditions.quaternions, self.scalar());
                let (lo, hi) = (beyond * range.lo, beyond * range.hi);
                Value { lo, hi, ..range }.read(self.scalar())
            }
            _ => Value::UNKNOWN,
        }
    }

    pub fn reason(&self, operand: Operand) -> Option<Reason> {
        match operand {
            Operand::Literal(_) | Operand::Input(_) => {
                let value = self.given(operand);
                let known = value != Value::UNKNOWN;
                (known && !value.fits(self.scalar())).then_some(Reason::Overflow)
            }
            Operand::Sin(k) | Operand::Cos(k) => self.turns.reason(k),
            Operand::Step(k) => self.steps[k as usize].reason,
        }
    }

    pub fn product(&self, [a, b]: [Operand; 2]) -> Value {
        if a == b {
            self.value(a).squared()
        } else {
            self.value(a).times(self.value(b))
        }
    }

    /// Rotation whose sine or cosine an operand is.
    pub fn place(&self, operand: Operand) -> Option<SineOrCosine> {
        match operand {
            Operand::Sin(angle) => Some(SineOrCosine { angle, sine: true }),
            Operand::Cos(angle) => Some(SineOrCosine { angle, sine: false }),
            Operand::Step(k) => self.steps[k as usize].place,
            Operand::Literal(_) | Operand::Input(_) => None,
        }
    }

    /// Entry of a rotation matrix that an operand is.
    pub fn entry(&self, operand: Operand) -> Option<RotationEntry> {
        match operand {
            Operand::Step(k) => self.steps[k as usize].entry,
            _ => None,
        }
    }

    /// Kind of a column.
    pub fn kind_of(&self, column: Monomial) -> ColumnKind {
        match column {
            Monomial::Product(_, b @ Operand::Input(_)) => ColumnKind::Times(b),
            Monomial::Product(a, _) => ColumnKind::Times(a),
            Monomial::Whole(Operand::Step(k)) => self.steps[k as usize].kind,
            Monomial::Whole(Operand::Sin(angle) | Operand::Cos(angle)) => {
                ColumnKind::ByRotation(angle)
            }
            Monomial::Whole(operand) => ColumnKind::Alone(operand),
        }
    }
}

/// Range and error of a literal: rounded to `f64` when printed, and then to the type. The error is bounded as if every
/// literal were inexact, so that all bounds scale with the unit roundoff. The exact number is within `open` of the
/// nearest number of 106 bits.
fn literal(number: f64, open: f64, scalar: Real) -> Value {
    let printed = f64::EPSILON / 2.0;
    let read = match scalar {
        Real::F32 => scalar.roundoff(),
        Real::F64 | Real::Generic => 0.0,
    };
    let subnormal = number != 0.0 && number.abs() < 2.0 * scalar.smallest();
    let lost = if subnormal { scalar.smallest() } else { 0.0 };
    let open_in_type = open * (scalar.roundoff() / Real::F64.roundoff());
    Value {
        error: (printed + read) * number.abs() + lost + open_in_type,
        ..Value::between(number - open, number + open)
    }
}
