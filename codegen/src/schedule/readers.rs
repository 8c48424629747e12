//! Last reader of each result of a program.
//!
//! In: steps. Out: for each step the last step that reads it.

use super::{Operand, Program, Step};

/// Last step that reads each step. Angles of sines, and these results, count as read after every block.
#[must_use]
pub fn read_until(program: &Program, results: &[Operand]) -> Vec<u32> {
    let mut read_until = vec![0; program.steps.len()];
    note_readers((0_u32..).zip(&program.steps), &mut read_until);
    for operand in program.angles.iter().chain(results) {
        if let Operand::Step(step) = *operand {
            read_until[step as usize] = u32::MAX;
        }
    }
    read_until
}

/// Records the last of these steps that reads each step.
pub fn note_readers<'s>(steps: impl Iterator<Item = (u32, &'s Step)>, read_until: &mut [u32]) {
    for (at, step) in steps {
        for operand in step.operation.operands() {
            if let Operand::Step(step) = operand {
                // Later steps come later.
                read_until[step as usize] = at;
            }
        }
    }
}
