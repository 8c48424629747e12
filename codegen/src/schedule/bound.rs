//! How far rounding can take the results of a program from those of exact arithmetic.
//!
//! In: a [`Program`], the range of its inputs and the type of number. Out: a bound for each result,
//! by a running error analysis: every step carries the range of its exact value and the greatest
//! error of the computed one. It holds whether products are fused with sums or not, for sines and
//! cosines within one unit in the last place, and where nothing underflows. It never runs the
//! program.

mod length;
#[cfg(test)]
mod tests;
mod value;

use self::length::{Form, Length, Lengths, Turn};
pub use self::value::Value;
use super::{Operand, Operation, Program};
use crate::expression::Input;
use crate::request::Real;

/// What the bounds are multiplied by for their own rounding, which they do not follow: more than
/// some million operations of `f64` on positive numbers can lose.
const SLACK: f64 = 1.0 + 1e-9;

/// The range of each result, and its greatest error; infinite where none can be given.
#[must_use]
pub fn results(program: &Program, scalar: Real, range: &dyn Fn(Input) -> Value) -> Vec<Value> {
    let mut known = Known {
        program,
        scalar,
        roundoff: scalar.roundoff(),
        range,
        turns: Vec::with_capacity(program.angles.len()),
        steps: Vec::with_capacity(program.steps.len()),
    };
    let mut lengths = Lengths::default();
    for (k, step) in program.steps.iter().enumerate() {
        if k == program.before_angles {
            known.turn();
        }
        let found = known.step(step.operation, &mut lengths);
        known.steps.push(found);
    }
    if program.before_angles == program.steps.len() {
        known.turn();
    }
    let results = program.results.iter().map(|&result| known.value(result));
    results
        .map(|value| Value {
            error: value.error * SLACK,
            ..value
        })
        .collect()
}

/// The greatest error of each result; infinite where none can be given.
#[must_use]
pub fn errors(program: &Program, scalar: Real, range: &dyn Fn(Input) -> Value) -> Vec<f64> {
    let results = results(program, scalar, range);
    results.into_iter().map(|value| value.error).collect()
}

/// The values of a program so far.
struct Known<'p> {
    program: &'p Program,
    scalar: Real,
    roundoff: f64,
    range: &'p dyn Fn(Input) -> Value,
    /// Sine and cosine of each angle.
    turns: Vec<[Value; 2]>,
    /// What each step computes, and how that came about.
    steps: Vec<(Value, Form)>,
}

/// A term of a sum.
#[derive(Clone, Copy)]
struct Term {
    /// Whether a minus stands before it.
    minus: bool,
    /// The term, where it has a place of its own.
    whole: Option<Operand>,
    /// What it is the product of, if it is one.
    factors: Option<[Operand; 2]>,
}

impl Known<'_> {
    fn value(&self, operand: Operand) -> Value {
        match operand {
            Operand::Literal(number) => literal(number, self.scalar),
            Operand::Input(input) => (self.range)(input),
            Operand::Sin(k) => self.turns[k as usize][0],
            Operand::Cos(k) => self.turns[k as usize][1],
            Operand::Step(k) => self.steps[k as usize].0,
        }
    }

    /// Takes in the sines and cosines.
    fn turn(&mut self) {
        let angles = self.program.angles.iter();
        let angles: Vec<Value> = angles.map(|&angle| self.value(angle)).collect();
        let both = |angle: Value| [angle.sine(self.roundoff), angle.cosine(self.roundoff)];
        self.turns = angles.into_iter().map(both).collect();
    }

    fn step(&self, operation: Operation, lengths: &mut Lengths) -> (Value, Form) {
        if let Some(terms) = self.terms(operation) {
            return self.sum(terms, lengths);
        }
        let exact = match operation {
            Operation::Mul(a, b) => self.product([a, b]),
            Operation::Div(a, b) => self.value(a).times(self.value(b).reciprocal()),
            Operation::Sqrt(a) => self.value(a).root(),
            // Only a result or an angle needs one: it is never part of a vector.
            Operation::Neg(a) => return (self.value(a).opposite(), Form::Plain),
            _ => unreachable!("a sum has terms"),
        };
        (exact.rounded(self.roundoff), Form::Plain)
    }

    fn product(&self, [a, b]: [Operand; 2]) -> Value {
        if a == b {
            self.value(a).squared()
        } else {
            self.value(a).times(self.value(b))
        }
    }

    /// The terms of an operation that is a sum.
    fn terms(&self, operation: Operation) -> Option<[Term; 2]> {
        let single = |whole: Operand, minus| {
            let factors = match whole {
                Operand::Step(k) => match self.program.steps[k as usize].operation {
                    Operation::Mul(a, b) => Some([a, b]),
                    _ => None,
                },
                _ => None,
            };
            Term {
                minus,
                whole: Some(whole),
                factors,
            }
        };
        let product = |a, b, minus| Term {
            minus,
            whole: None,
            factors: Some([a, b]),
        };
        Some(match operation {
            Operation::Add(a, b) => [single(a, false), single(b, false)],
            Operation::Sub(a, b) => [single(a, false), single(b, true)],
            Operation::MulAdd(a, b, c) => [product(a, b, false), single(c, false)],
            Operation::MulSub(a, b, c) => [product(a, b, false), single(c, true)],
            Operation::NegMulAdd(a, b, c) => [product(a, b, true), single(c, false)],
            Operation::Mul(..) | Operation::Div(..) | Operation::Sqrt(_) | Operation::Neg(_) => {
                return None;
            }
        })
    }

    fn sum(&self, terms: [Term; 2], lengths: &mut Lengths) -> (Value, Form) {
        // A product is rounded before it is added, or else the error is smaller.
        let [a, b] = terms.map(|term| match (term.whole, term.factors) {
            (Some(whole), _) => self.value(whole),
            (None, Some(factors)) => self.product(factors).rounded(self.roundoff),
            (None, None) => Value::UNKNOWN,
        });
        let signed = |value: Value, minus| if minus { value.opposite() } else { value };
        let sum = signed(a, terms[0].minus).plus(signed(b, terms[1].minus));
        let sum = sum.rounded(self.roundoff);
        let wholes = (terms[0].whole, terms[1].whole);
        let form = match wholes {
            (Some(a), Some(b)) => Form::Sum(a, b),
            (None, Some(rest)) => Form::More(rest, a),
            (_, None) => Form::Plain,
        };
        let [Some([x, y]), Some([z, w])] = terms.map(|term| term.factors) else {
            return (sum, form);
        };
        // x y ± z w is the product of the vectors (x, z) and (y, ±w), and of (x, w) and (y, ±z).
        let sum =
            [([x, z], [y, w]), ([x, w], [y, z])]
                .into_iter()
                .fold(sum, |sum, (left, right)| {
                    let [left, right] = [left, right].map(|pair| lengths.of(self, &pair));
                    let error = left.across(right) + self.roundings(left, right);
                    sum.within(left.size * right.size, error)
                });
        let turn = Turn::of([x, y], terms[0].minus, [z, w], terms[1].minus);
        (sum, turn.map_or(form, Form::Turned))
    }

    /// What the roundings of two products and their sum amount to.
    fn roundings(&self, left: Length, right: Length) -> f64 {
        let size = (left.size + left.error) * (right.size + right.error);
        (2.0 + self.roundoff) * self.roundoff * size
    }
}

/// A number of the generated code: rounded to `f64` when it was printed, and to the type.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the rounding is what is asked for"
)]
fn literal(number: f64, scalar: Real) -> Value {
    let printed = f64::EPSILON / 2.0 * number.abs();
    let read = match scalar {
        Real::F32 => (f64::from(number as f32) - number).abs(),
        Real::F64 | Real::Generic => 0.0,
    };
    Value {
        error: printed + read,
        ..Value::between(number, number)
    }
}
