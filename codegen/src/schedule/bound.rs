//! Bounds of the rounding errors of a program by a running error analysis.
//!
//! In: a [`Program`] and its [`Conditions`]. Out: a bound for each result. Every step has the range of its exact value
//! and a bound of the error of the computed value. Bounds hold with and without fused operations, for sines and cosines
//! within one ulp, and whether subnormal numbers are rounded or flushed to zero. A value that may overflow has no
//! bound.

mod combination;
mod group;
mod kind;
mod known;
mod length;
mod norm;
mod quaternion;
mod reason;
mod rotation;
mod term;
#[cfg(test)]
mod tests;
mod value;

use self::combination::ROWS;
use self::kind::{ColumnKind, Follows, StepForm, is_sum};
pub use self::known::Conditions;
use self::known::{Computed, Known};
use self::length::Lengths;
pub(crate) use self::norm::root;
use self::quaternion::Polynomials;
pub use self::reason::Reason;
use self::rotation::{PlaneRotation, PlaneRotations};
use self::term::Term;
use self::value::SLACK;
pub use self::value::Value;
use super::{Operand, Operation, Program, Step};

/// Bound of a result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResultBound {
    /// Range and error; the error is infinite without a bound.
    pub value: Value,
    /// Reason why there is no bound; `None` also if an input is unknown.
    pub reason: Option<Reason>,
}

/// Bound of each result.
#[must_use]
pub fn results(program: &Program, conditions: &Conditions<'_>) -> Vec<ResultBound> {
    let mut known = Known {
        program,
        conditions,
        turns: PlaneRotations::default(),
        polynomials: Polynomials::default(),
        steps: Vec::with_capacity(program.steps.len()),
    };
    let mut lengths = Lengths::default();
    for (k, step) in program.steps.iter().enumerate() {
        if k == program.before_angles {
            known.rotation();
        }
        known.take(step, &mut lengths);
    }
    if program.before_angles == program.steps.len() {
        known.rotation();
    }
    let results = program.results.iter();
    let found = results.map(|&result| ResultBound {
        // No operation reads an argument that is a result.
        value: match result {
            Operand::Input(input) => (conditions.range)(input),
            other => known.value(other),
        },
        reason: known.reason(result),
    });
    found
        .map(|found| ResultBound {
            value: Value {
                error: found.value.error * SLACK,
                ..found.value
            },
            ..found
        })
        .collect()
}

impl<'p> Known<'p> {
    /// Adds the sines and cosines.
    fn rotation(&mut self) {
        for &angle in &self.program.angles {
            let value = self.value(angle);
            let reach = value.size() + value.error * SLACK;
            let reason = if reach <= self.conditions.angles {
                None
            } else {
                self.reason(angle).or(Some(Reason::Angle))
            };
            self.turns.push(value, reason, self.scalar());
        }
    }

    /// Adds a step.
    fn take(&mut self, taken: &'p Step, lengths: &mut Lengths) {
        let operation = taken.operation;
        let step = u32::try_from(self.steps.len()).expect("fewer than 2³² steps");
        let Conditions {
            quaternions,
            scalar,
            ..
        } = *self.conditions;
        let polynomial = (self.polynomials).take(step, operation, quaternions, scalar);
        let (range, entry) = polynomial.map_or((None, None), |(range, entry)| (Some(range), entry));
        let (value, form) = self.step(operation, range, lengths);
        let place = match form {
            StepForm::ByRotation(rotation) => self.turns.place(step, &rotation),
            _ => None,
        };
        let value = value.unwrap_or(Value::UNKNOWN);
        let fits = value.fits(self.scalar());
        self.steps.push(Computed {
            value: if fits { value } else { Value::UNKNOWN },
            form,
            reason: (!fits).then(|| self.why(operation)).flatten(),
            place,
            follows: match entry {
                None => Follows::of(taken, &form),
                Some(_) => Follows::Never,
            },
            kind: ColumnKind::of(Operand::Step(step), taken.label, &form, place),
            entry,
        });
        if fits && is_sum(operation) {
            let length = lengths.of(self, &[Operand::Step(step)]);
            self.steps[step as usize].value = value.within(length.size, length.error);
        }
    }

    /// Reason why an operation has no bound; `None` if an operand is unknown.
    fn why(&self, operation: Operation) -> Option<Reason> {
        let operands = operation.operands();
        if let Some(reason) = operands.iter().find_map(|&operand| self.reason(operand)) {
            return Some(reason);
        }
        let known = |operand: &Operand| self.value(*operand) != Value::UNKNOWN;
        operands.iter().all(known).then_some(match operation {
            Operation::Div(..) | Operation::Sqrt(_) => Reason::Divisor,
            _ => Reason::Overflow,
        })
    }

    /// Range and error of a result, within `range` if it is known; `None` if an intermediate value may overflow.
    fn step(
        &self,
        operation: Operation,
        range: Option<[f64; 2]>,
        lengths: &mut Lengths,
    ) -> (Option<Value>, StepForm) {
        if let Some(terms) = self.terms(operation) {
            return self.sum(terms, range, lengths);
        }
        let exact = match operation {
            Operation::Mul(a, b) => self.product([a, b]),
            Operation::Div(a, b) => self.value(a).times(self.value(b).reciprocal()),
            Operation::Sqrt(a) => match self.squares(a) {
                Some(entries) => {
                    let length = lengths.of(self, &entries);
                    length.root_of(self.value(a), self.scalar())
                }
                None => self.value(a).root(),
            },
            // Exact, and not part of a vector.
            Operation::Sign(a) => {
                return (Some(self.value(a).sign(self.scalar())), StepForm::Plain);
            }
            // Negations occur only before results and angles, never within a vector.
            Operation::Neg(a) => return (Some(self.value(a).opposite()), StepForm::Plain),
            _ => unreachable!("a sum has terms"),
        };
        (
            Some(exact.kept(range).rounded(self.scalar())),
            StepForm::Plain,
        )
    }

    /// The entries of a vector whose square an operand is.
    fn squares(&self, operand: Operand) -> Option<Vec<Operand>> {
        let square = |operand: Operand| match operand {
            Operand::Step(step) => match self.program.steps[step as usize].operation {
                Operation::Mul(x, y) if x == y => Some(x),
                _ => None,
            },
            _ => None,
        };
        let (mut entries, mut at) = (Vec::new(), operand);
        while entries.len() < ROWS {
            if let Some(entry) = square(at) {
                entries.push(entry);
                return Some(entries);
            }
            let Operand::Step(step) = at else { break };
            let (entry, rest) = match self.program.steps[step as usize].operation {
                Operation::MulAdd(x, y, rest) if x == y => (x, rest),
                Operation::Add(a, b) => match (square(a), square(b)) {
                    (Some(entry), _) => (entry, b),
                    (None, Some(entry)) => (entry, a),
                    (None, None) => break,
                },
                _ => break,
            };
            entries.push(entry);
            at = rest;
        }
        None
    }

    fn sum(
        &self,
        terms: [Term; 2],
        range: Option<[f64; 2]>,
        lengths: &mut Lengths,
    ) -> (Option<Value>, StepForm) {
        // A product is rounded before the sum; if they are fused, the error is smaller.
        let [a, b] = terms.map(|term| match (term.whole, term.factors) {
            (Some(whole), _) => self.value(whole),
            (None, Some(factors)) => self.product(factors).rounded(self.scalar()),
            (None, None) => Value::UNKNOWN,
        });
        if !(a.fits(self.scalar()) && b.fits(self.scalar())) {
            return (None, StepForm::Plain);
        }
        let signed = |value: Value, minus| if minus { value.opposite() } else { value };
        let sum = signed(a, terms[0].minus).plus(signed(b, terms[1].minus));
        let sum = sum.kept(range);
        let wholes = (terms[0].whole, terms[1].whole);
        let sum = if range.is_some() && wholes.0.is_some() && wholes.0 == wholes.1 {
            // For an entry a of a quaternion, 2 a has the digits of a unless they are subnormal; a − a is 0.
            sum.read(self.scalar())
        } else {
            sum.rounded(self.scalar())
        };
        let form = match wholes {
            (Some(a), Some(b)) => StepForm::Sum(a, b),
            (None, Some(rest)) => StepForm::More(rest, a),
            (_, None) => StepForm::Plain,
        };
        let [Some([x, y]), Some([z, w])] = terms.map(|term| term.factors) else {
            return (Some(sum), form);
        };
        // x y ± z w is the product of the vectors (x, z) and (y, ±w), and of (x, w) and (y, ±z).
        let sum =
            [([x, z], [y, w]), ([x, w], [y, z])]
                .into_iter()
                .fold(sum, |sum, (left, right)| {
                    let [left, right] = [left, right].map(|pair| lengths.of(self, &pair));
                    let error = left.across(right) + left.roundings(right, self.scalar());
                    sum.within(left.size * right.size, error)
                });
        let place = |operand| self.place(operand);
        let rotation = PlaneRotation::of(place, [x, y], terms[0].minus, [z, w], terms[1].minus);
        (Some(sum), rotation.map_or(form, StepForm::ByRotation))
    }
}
