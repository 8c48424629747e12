//! Inlined values: those that are written inside of what reads them, so that they need no name.
//!
//! In: an [`Arranged`] program. Out: for each step, the place where its operation is written. A value without a meaning
//! that is read once, by the next statement, is a part of that statement's expression; one that a section stores is
//! computed there, and so is one of a loop that does not read it itself. Operations and their operands stay as they are,
//! so results are the same bits.

#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::ops::Range;

use super::repeats::{Over, Repeat};
use super::{Arranged, Operand, Operation, Program, number};

/// Maximum number of operands of an expression: three products, as a row of a rotation times a vector has.
const OPERANDS: usize = 6;

/// Place where the operation of a step is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// A statement that binds its result to a name.
    Statement,
    /// The operation that reads it.
    Reader,
    /// The statement that stores it.
    Store,
}

/// Places of all steps of a program.
#[derive(Clone, Debug)]
pub struct Inlined(Vec<Place>);

impl Inlined {
    /// Places of the steps of a program; values that have a meaning get a name, but for those of loops over columns.
    #[must_use]
    pub fn of(arranged: &Arranged<'_>, has_meaning: impl Fn(u32) -> bool) -> Self {
        let program = &*arranged.program;
        let reads = reads(program);
        let mut places = vec![Place::Statement; program.steps.len()];
        for stretch in stretches(arranged) {
            let is_named = |step| stretch.has_meanings && has_meaning(step);
            stretch.inline(program, &reads, is_named, &mut places);
        }
        Self(places)
    }

    /// No inlined values.
    #[cfg(test)]
    pub fn none(steps: usize) -> Self {
        Self(vec![Place::Statement; steps])
    }

    /// True if a step is written inside of the operation that reads it.
    #[must_use]
    pub fn in_reader(&self, step: u32) -> bool {
        self.0[step as usize] == Place::Reader
    }

    /// True if a step is written inside of the statement that stores it.
    #[must_use]
    pub fn in_store(&self, step: u32) -> bool {
        self.0[step as usize] == Place::Store
    }
}

/// Number of times that each step is read; angles count twice, for sine and cosine, and so do results, which are read
/// at the end.
fn reads(program: &Program) -> Vec<u32> {
    let mut reads = vec![0; program.steps.len()];
    let steps = program.steps.iter();
    let by_steps = steps.flat_map(|step| step.operation.operands());
    let others = program.angles.iter().chain(&program.results);
    let read = by_steps.map(|of| (of, 1)).chain(others.map(|&of| (of, 2)));
    for (operand, times) in read {
        if let Operand::Step(step) = operand {
            reads[step as usize] += times;
        }
    }
    reads
}

/// Consecutive steps that are written one after the other, in one function.
struct Stretch {
    steps: Range<u32>,
    /// False in loops over columns, whose values stand for entries of several matrices.
    has_meanings: bool,
    /// Steps that are stored, in the work array or a table, as soon as they are computed.
    stored: BTreeSet<u32>,
    /// True if its own steps read what they have stored. In loops, compilers compare all addresses before they vectorize.
    reads_stored: bool,
}

impl Stretch {
    fn straight(steps: Range<u32>) -> Self {
        Self {
            steps,
            has_meanings: true,
            stored: BTreeSet::new(),
            reads_stored: false,
        }
    }

    /// The first iteration of a loop; the others are not written.
    fn iteration(repeat: &Repeat) -> Self {
        Self {
            steps: repeat.first.clone(),
            has_meanings: repeat.over == Over::Limbs,
            stored: repeat.stores.iter().copied().collect(),
            reads_stored: false,
        }
    }

    /// Notes the places of its steps.
    fn inline(
        &self,
        program: &Program,
        reads: &[u32],
        is_named: impl Fn(u32) -> bool,
        places: &mut [Place],
    ) {
        let own = |operand| match operand {
            Operand::Step(step) if self.steps.contains(&step) => Some(step),
            _ => None,
        };
        let mut has_reader = vec![false; self.steps.len()];
        let operations = || {
            self.steps
                .clone()
                .map(|at| program.steps[at as usize].operation)
        };
        let read = operations().flat_map(|operation| operation.operands());
        for step in read.filter_map(own) {
            has_reader[(step - self.steps.start) as usize] = true;
        }
        // Steps that wait for their reader, with the numbers of their operands.
        let mut waiting: Vec<(u32, usize)> = Vec::new();
        for (at, operation) in self.steps.clone().zip(operations()) {
            let operands = operation.operands();
            let is_part = |&(step, _): &(u32, usize)| operands.contains(&Operand::Step(step));
            // A sign is the difference of two comparisons, each of which reads the operand.
            let may_have_parts = !matches!(operation, Operation::Sign(_));
            let mut size = operands.len();
            let mut first = waiting.len();
            while may_have_parts
                && let Some(part) = waiting[..first].last().filter(|step| is_part(step))
                && size + part.1 - 1 <= OPERANDS
            {
                size += part.1 - 1;
                first -= 1;
            }
            for (part, _) in waiting.drain(first..) {
                places[part as usize] = Place::Reader;
            }
            // A part that stands before a statement is none, so that steps are computed in their order.
            if waiting.iter().any(is_part) {
                waiting.clear();
            }
            let is_open = !is_named(at);
            let has_reader = has_reader[(at - self.steps.start) as usize];
            if is_open && has_reader && reads[at as usize] == 1 && !self.stored.contains(&at) {
                waiting.push((at, size));
                continue;
            }
            waiting.clear();
            if is_open && (!has_reader || self.reads_stored) && self.stored.contains(&at) {
                places[at as usize] = Place::Store;
            }
        }
    }
}

/// All stretches of a program.
fn stretches(arranged: &Arranged<'_>) -> Vec<Stretch> {
    let program = &*arranged.program;
    let [first, end] = [program.before_angles, program.steps.len()].map(number);
    let mut stretches = vec![Stretch::straight(0..first)];
    if let Some(sections) = &arranged.sections {
        stretches.extend(
            sections
                .sections
                .iter()
                .map(|section| match &section.repeat {
                    Some(repeat) => Stretch::iteration(repeat),
                    None => Stretch {
                        stored: section.stores.iter().map(|&(step, _)| step).collect(),
                        reads_stored: true,
                        ..Stretch::straight(section.steps.clone())
                    },
                }),
        );
        return stretches;
    }
    let mut start = first;
    for repeat in &arranged.repeats {
        let steps = repeat.steps();
        stretches.push(Stretch::straight(start..steps.start));
        stretches.push(Stretch::iteration(repeat));
        start = steps.end;
    }
    stretches.push(Stretch::straight(start..end));
    stretches
}
