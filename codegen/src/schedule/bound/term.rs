//! Sums as terms, and terms as products.
//!
//! In: an operation. Out: its terms, each with the factors that it is a product of, wherever these
//! were multiplied. It never looks at a value.

use super::known::Known;
use crate::schedule::{Operand, Operation};

/// A term of a sum.
#[derive(Clone, Copy)]
pub struct Term {
    /// Whether a minus stands before it.
    pub minus: bool,
    /// The term, where it has a place of its own.
    pub whole: Option<Operand>,
    /// What it is the product of, if it is one.
    pub factors: Option<[Operand; 2]>,
}

impl Known<'_> {
    /// The terms of an operation that is a sum.
    pub fn terms(&self, operation: Operation) -> Option<[Term; 2]> {
        let single = |whole: Operand, minus| {
            let factors = match whole {
                Operand::Step(k) => match self.program.steps[k as usize].operation {
                    Operation::Mul(a, b) => Some([a, b]),
                    _ => None,
                },
                // As if it were multiplied by 1: a shift of an angle by nearly nothing leaves this.
                Operand::Sin(_) | Operand::Cos(_) => Some([whole, Operand::Literal(1.0)]),
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
            Operation::Mul(..)
            | Operation::Div(..)
            | Operation::Sqrt(_)
            | Operation::Sign(_)
            | Operation::Neg(_) => {
                return None;
            }
        })
    }
}
