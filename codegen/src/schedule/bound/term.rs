//! Sums as terms, and terms as products.
//!
//! In: an operation. Out: its terms, each with its factors, whether they are multiplied in the same step or an earlier
//! one.

use super::known::Known;
use crate::schedule::{Operand, Operation};

/// A term of a sum.
#[derive(Clone, Copy)]
pub struct Term {
    /// True if it is subtracted.
    pub minus: bool,
    /// The term as an operand, if it is one.
    pub whole: Option<Operand>,
    /// Factors, if it is a product.
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
                // As a product with 1, which remains of a shift by an angle near zero.
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
