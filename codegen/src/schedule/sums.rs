//! Sums of coordinates, which are named after them.
//!
//! In: a program. Out: the coordinates whose sum an operand is.

use super::{Operand, Operation, Program};
use crate::expression::Input;
use crate::space::Variable;

/// For each step, the indices of the coordinates whose sum it is, in ascending order; `None` for all others.
#[derive(Clone, Debug, Default)]
pub struct Sums(Vec<Option<Vec<u16>>>);

impl Sums {
    /// Sums of a program.
    #[must_use]
    pub fn of(program: &Program) -> Self {
        let mut sums = Self(Vec::with_capacity(program.steps.len()));
        for step in &program.steps {
            let sum = match step.operation {
                Operation::Add(a, b) => sums.both(a, b),
                _ => None,
            };
            sums.0.push(sum);
        }
        sums
    }

    /// Coordinates whose sum a step is.
    #[must_use]
    pub fn of_step(&self, step: u32) -> Option<&[u16]> {
        self.0.get(step as usize)?.as_deref()
    }

    /// Coordinates whose sum an operand is; a coordinate is that of itself.
    #[must_use]
    pub fn of_operand(&self, operand: Operand) -> Option<Vec<u16>> {
        match operand {
            Operand::Input(Input::Variable(Variable::Q, k)) => Some(vec![k]),
            Operand::Step(step) => self.of_step(step).map(<[u16]>::to_vec),
            _ => None,
        }
    }

    fn both(&self, a: Operand, b: Operand) -> Option<Vec<u16>> {
        let mut coordinates = self.of_operand(a)?;
        coordinates.extend(self.of_operand(b)?);
        coordinates.sort_unstable();
        Some(coordinates)
    }
}
