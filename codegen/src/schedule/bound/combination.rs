//! Linear combinations: steps as sums of other values with literal factors, as constant rotations, offsets and inertias
//! give them.
//!
//! In: up to three steps. Out: the matrix A of y = A x, where x are labelled values or values that are not linear
//! combinations with literals, and the rounding errors on the way from x to y.

use super::kind::{Follows, Monomial, is_sum};
use super::known::Known;
use crate::schedule::{Operand, Operation};

/// Maximum number of steps of a combination.
pub const ROWS: usize = 3;

/// Maximum number of columns plus substituted steps.
const MOST: usize = 24;

/// Column of A.
#[derive(Clone, Debug)]
pub struct Column {
    /// Value that it multiplies.
    pub of: Monomial,
    /// Entries.
    pub entries: [f64; ROWS],
}

/// y = A x, and the error of y beyond that of x.
pub struct Combination {
    /// Columns of A.
    pub columns: Vec<Column>,
    /// Error of each entry of y.
    pub lost: [f64; ROWS],
}

impl Combination {
    /// Combination of some steps; `None` if no step can be substituted.
    pub fn of(known: &Known<'_>, steps: &[u32]) -> Option<Self> {
        let mut found = Self {
            columns: Vec::with_capacity(8),
            lost: [0.0; ROWS],
        };
        for (row, &step) in steps.iter().enumerate() {
            let mut entries = [0.0; ROWS];
            entries[row] = 1.0;
            found.add(Monomial::Whole(Operand::Step(step)), entries);
        }
        let mut followed = 0;
        // The latest step first, so that all its readers have been substituted before it.
        while let Some((at, step)) = found.youngest(known, steps)
            && found.columns.len() + followed < MOST
        {
            let column = found.columns.swap_remove(at);
            found.follow(known, step, column.entries);
            followed += 1;
        }
        (followed > 0).then_some(found)
    }

    /// Column of the latest step that can be substituted.
    fn youngest(&self, known: &Known<'_>, asked: &[u32]) -> Option<(usize, u32)> {
        let mut youngest: Option<(usize, u32)> = None;
        for (at, column) in self.columns.iter().enumerate() {
            if let Monomial::Whole(Operand::Step(k)) = column.of {
                let follows = match known.steps[k as usize].follows {
                    Follows::Always => true,
                    Follows::First => asked.contains(&k),
                    Follows::Never => false,
                };
                if follows && youngest.is_none_or(|(_, other)| k > other) {
                    youngest = Some((at, k));
                }
            }
        }
        youngest
    }

    /// Substitutes the operands of a step for the step.
    fn follow(&mut self, known: &Known<'_>, step: u32, entries: [f64; ROWS]) {
        let operation = known.program.steps[step as usize].operation;
        let rounding = rounded(known, known.steps[step as usize].value.reach());
        let (product, rest) = match operation {
            Operation::Add(a, b) => (None, vec![(1.0, a), (1.0, b)]),
            Operation::Sub(a, b) => (None, vec![(1.0, a), (-1.0, b)]),
            Operation::Mul(a, b) => (Some((1.0, a, b)), Vec::new()),
            Operation::MulAdd(a, b, c) => (Some((1.0, a, b)), vec![(1.0, c)]),
            Operation::MulSub(a, b, c) => (Some((1.0, a, b)), vec![(-1.0, c)]),
            Operation::NegMulAdd(a, b, c) => (Some((-1.0, a, b)), vec![(1.0, c)]),
            Operation::Div(..) | Operation::Sqrt(_) | Operation::Sign(_) | Operation::Neg(_) => {
                unreachable!("only sums and products are followed")
            }
        };
        // For a separate product, its rounding is that of the step.
        let mut lost = if is_sum(operation) { rounding } else { 0.0 };
        for (factor, operand) in rest {
            self.add(
                Monomial::Whole(operand),
                entries.map(|entry| factor * entry),
            );
        }
        if let Some((sign, a, b)) = product {
            let number = match (a, b) {
                (Operand::Literal(number), x) | (x, Operand::Literal(number)) => Some((number, x)),
                _ => None,
            };
            if let Some((number, x)) = number {
                let x_reach = known.value(x).reach();
                let factor = known.value(Operand::Literal(number));
                lost += factor.error * x_reach + rounded(known, factor.reach() * x_reach);
                self.add(
                    Monomial::Whole(x),
                    entries.map(|entry| sign * number * entry),
                );
            } else {
                lost += rounded(known, known.product([a, b]).reach());
                self.add(Monomial::Product(a, b), entries.map(|entry| sign * entry));
            }
        }
        for (sum, entry) in self.lost.iter_mut().zip(entries) {
            *sum += entry.abs() * lost;
        }
    }

    fn add(&mut self, of: Monomial, entries: [f64; ROWS]) {
        match self.columns.iter_mut().find(|column| column.of == of) {
            Some(column) => {
                for (sum, entry) in column.entries.iter_mut().zip(entries) {
                    *sum += entry;
                }
            }
            None => self.columns.push(Column { of, entries }),
        }
    }
}

/// Bound of the rounding error of a result of this magnitude.
fn rounded(known: &Known<'_>, reach: f64) -> f64 {
    known.scalar().roundoff() * reach + known.scalar().smallest()
}
