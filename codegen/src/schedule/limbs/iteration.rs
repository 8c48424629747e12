//! One iteration of a loop over limbs.
//!
//! In: groups of operations. Out: rows: the same operation in each lane, with operands from outside or from earlier
//! rows. An operation with another sign than in the first lane gets an operand that a row multiplies by 1 or −1.

use std::collections::HashMap;

use super::groups::{Groups, Like};
use crate::schedule::sections::Shared;
use crate::schedule::{Operand, Operation, Program};

/// Operand in a loop.
#[derive(Clone, Copy, Debug)]
pub enum LoopOperand {
    /// Value from before the loop.
    Outside(Operand),
    /// Result of an earlier row in the same lane.
    Inside(usize),
}

/// For each lane: the step that a row computes, if it is one, and its operation.
pub type IterationRow = Vec<(Option<u32>, Operation<LoopOperand>)>;

/// Iteration of a loop.
pub struct Iteration<'g> {
    groups: &'g Groups,
    /// Row of each group that the loop computes.
    own: HashMap<usize, usize>,
    /// Row of the values of all lanes with these signs; true is minus.
    signed: HashMap<Vec<(Shared, bool)>, usize>,
    /// Rows, operands before their readers.
    pub rows: Vec<IterationRow>,
}

impl<'g> Iteration<'g> {
    /// Iteration that computes nothing yet.
    pub fn new(groups: &'g Groups) -> Self {
        Self {
            groups,
            own: HashMap::new(),
            signed: HashMap::new(),
            rows: Vec::new(),
        }
    }

    /// Iteration that computes some groups, operands before their readers.
    pub fn of(program: &Program, groups: &'g Groups, members: &[usize]) -> Self {
        let mut iteration = Self::new(groups);
        for &group in members {
            iteration.push(program, group);
        }
        iteration
    }

    /// Adds a group whose operands are there.
    pub fn push(&mut self, program: &Program, group: usize) {
        let steps = self.groups.all[group].lanes.iter().map(|lane| match lane {
            Operand::Step(step) => *step,
            _ => unreachable!("loops compute steps"),
        });
        let steps: Vec<u32> = steps.collect();
        let operation = |&step: &u32| program.steps[step as usize].operation;
        let operations: Vec<Operation> = steps.iter().map(operation).collect();
        let row = self.row(&operations);
        let steps = steps.into_iter().map(Some);
        self.own.insert(group, self.rows.len());
        self.rows.push(steps.zip(row).collect());
    }

    fn read(&self, operand: Operand) -> LoopOperand {
        let own = match self.groups.like(operand) {
            Like::Group(group) => self.own.get(&group),
            Like::Same(_) | Like::Literal | Like::Other => None,
        };
        own.map_or(LoopOperand::Outside(operand), |&row| {
            LoopOperand::Inside(row)
        })
    }

    /// The operations of a group in the form of that of its first lane.
    fn row(&mut self, operations: &[Operation]) -> Vec<Operation<LoopOperand>> {
        let all: Vec<Signed> = (operations.iter()).map(Signed::of).collect();
        let like = |signed: &Signed| self.groups.like(signed.operands[0]);
        let first = like(&all[0]);
        let all = all.into_iter().map(|signed| {
            let found = like(&signed);
            if found == first {
                return signed;
            }
            let swapped = signed.swapped();
            let is_first = like(&swapped) != first && found.loose() == first.loose();
            if is_first { signed } else { swapped }
        });
        let all: Vec<Signed> = all.collect();
        let minus = all[0].minus;
        let signs = |term: usize| -> Vec<bool> {
            let signs = all.iter().map(|signed| signed.minus[term] != minus[term]);
            signs.collect()
        };
        let count = all[0].operands.len();
        // The sign of a product is that of a literal factor, if there is one.
        let factor = usize::from(count == 3 && matches!(all[0].operands[1], Operand::Literal(_)));
        let none = vec![false; all.len()];
        let columns = (0..count).map(|k| {
            let column: Vec<Operand> = all.iter().map(|signed| signed.operands[k]).collect();
            let minus = if k == factor {
                signs(0)
            } else if k + 1 == count {
                signs(1)
            } else {
                none.clone()
            };
            self.with_signs(&column, minus)
        });
        let columns: Vec<Vec<LoopOperand>> = columns.collect();
        let lanes = (0..all.len()).map(|lane| {
            let mut reads = columns.iter().map(|column| column[lane]);
            operations[0].map(|_| reads.next().expect("an operand for each place"))
        });
        lanes.collect()
    }

    /// A value in each lane, negated where its sign is minus.
    fn with_signs(&mut self, values: &[Operand], minus: Vec<bool>) -> Vec<LoopOperand> {
        if !minus.contains(&true) {
            return values.iter().map(|&value| self.read(value)).collect();
        }
        let shared: Option<Vec<Shared>> = values.iter().copied().map(Shared::of).collect();
        let signs = values.iter().zip(&minus);
        let Some(shared) = shared else {
            let turned = signs.map(|(&value, &minus)| match value {
                Operand::Literal(literal) if minus => {
                    LoopOperand::Outside(Operand::Literal(-literal))
                }
                value => LoopOperand::Outside(value),
            });
            return turned.collect();
        };
        let product = signs.map(|(&value, &minus)| {
            let sign = Operand::Literal(if minus { -1.0 } else { 1.0 });
            (
                None,
                Operation::Mul(LoopOperand::Outside(sign), self.read(value)),
            )
        });
        let row: IterationRow = product.collect();
        let key = shared.into_iter().zip(minus).collect();
        let row = *self.signed.entry(key).or_insert_with(|| {
            self.rows.push(row);
            self.rows.len() - 1
        });
        vec![LoopOperand::Inside(row); values.len()]
    }
}

/// Operands of an operation, with the signs of its terms.
#[derive(Clone)]
struct Signed {
    operands: Vec<Operand>,
    /// Signs of the first term, which may be a product, and of the last one; true is minus. Both are plus for other
    /// operations than sums.
    minus: [bool; 2],
    commutes: bool,
}

impl Signed {
    fn of(operation: &Operation) -> Self {
        let minus = match operation {
            Operation::Sub(..) | Operation::MulSub(..) => [false, true],
            Operation::NegMulAdd(..) => [true, false],
            _ => [false, false],
        };
        let operands = operation.operands();
        Self {
            commutes: operands.len() > 1 && !matches!(operation, Operation::Div(..)),
            operands,
            minus,
        }
    }

    /// The same with both terms of a sum, or both factors, in the other order.
    fn swapped(&self) -> Self {
        let mut swapped = self.clone();
        if self.commutes {
            swapped.operands.swap(0, 1);
            if self.operands.len() == 2 {
                swapped.minus.swap(0, 1);
            }
        }
        swapped
    }
}
