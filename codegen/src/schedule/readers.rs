//! Until when each result of a program is read.
//!
//! In: steps. Out: for each the last step that reads it.

use super::{Operand, Program, Step};

/// The last step that reads each step; what sines are of, and these results, is read behind every block.
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

/// Notes of each step which of these is the last that reads it.
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
