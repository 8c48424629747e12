//! Sections of a long routine, each a function of its own.
//!
//! In: the sections of a program, and the naming of its routine. Out: the routine, with the values that each section
//! reads from the work array, computes, and stores there.

use std::collections::{BTreeSet, HashMap};

use super::{Entries, Naming, Routine, Statement, StorePlace, Value};
use crate::schedule::blocks::{before, within};
use crate::schedule::repeats::Repeat;
use crate::schedule::sections::{Section, Sections, Shared};
use crate::schedule::{Operand, Program, Step};
use crate::space::Variable;

/// Sections of a routine and their work array.
#[derive(Clone, Debug, PartialEq)]
pub struct Work {
    /// Name of the work array.
    pub name: String,
    /// Length of the work array.
    pub len: usize,
    /// Index and value of the entries that are stored before the first section.
    pub initial: Vec<(usize, Value)>,
    /// Sections in execution order.
    pub sections: Vec<SectionBody>,
}

/// Section: a function of the work array alone.
#[derive(Clone, Debug, PartialEq)]
pub struct SectionBody {
    /// Name of the function.
    pub name: String,
    /// Indices of the entries that it reads, and the names that they get.
    pub loads: Vec<(usize, String)>,
    /// Statements, with stores to the array.
    pub statements: Vec<Statement>,
    /// True if a value is a literal.
    pub has_literals: bool,
    /// True if an operation is fused.
    pub is_fused: bool,
}

impl Naming<'_> {
    /// The routine with its sections.
    pub(super) fn in_sections(
        mut self,
        sections: &Sections,
        arguments: Vec<(Variable, Entries)>,
        fields: Vec<Entries>,
    ) -> Routine {
        let program = self.program;
        let name = self.names.fresh("work");
        let mut statements = self.statements(&before(program, self.inlined));
        statements.extend(self.sines_and_cosines());
        let initial = sections.initial.iter();
        let initial = initial.map(|&(value, place)| (place, self.value(value.operand())));
        let initial = initial.collect();
        let results = program.results.iter().zip(&sections.results);
        let results = results.map(|(&result, place)| match place {
            Some(place) => Value::Work(*place),
            None => self.value(result),
        });
        let results: Vec<Value> = results.collect();
        for &(value, place) in &sections.initial {
            if let Shared::Step(step) = value {
                self.leave_unnamed(step, place);
            }
        }
        let each = sections.sections.iter().zip(1..);
        let each = each.map(|(section, number)| self.section_body(section, number));
        let each = each.collect();
        Routine {
            arguments,
            fields,
            statements,
            work: Some(Work {
                name,
                len: sections.work,
                initial,
                sections: each,
            }),
            results,
            stored: BTreeSet::new(),
            // Filling the array with zeros needs a literal.
            has_literals: true,
            is_fused: is_fused(&program.steps[..program.before_angles]),
            names: self.names,
            meanings: self.meanings,
        }
    }

    fn section_body(&mut self, section: &Section, number: usize) -> SectionBody {
        let name = self.names.fresh(&format!("section_{number}"));
        self.unnamed = 0;
        let mut loads = Vec::new();
        // Values that have names in this loop alone.
        let mut anew = Vec::new();
        let mut waiting = HashMap::new();
        let readers = readers(self.program, section);
        for &(value, place) in &section.loads {
            let known = match self.value(value.operand()) {
                Value::Name(name) => Some(name),
                _ => None,
            };
            // A name of its own would say nothing, but a loop reads what all iterations share before it.
            let needs_none = known.is_none() && section.repeat.is_none();
            if needs_none || readers[&value] == 1 {
                waiting.insert(value, place);
                continue;
            }
            let name = known.unwrap_or_else(|| {
                let name = self.unnamed();
                if let Shared::Step(step) = value {
                    self.steps[step as usize] = Value::Name(name.clone());
                    anew.push((step, place));
                }
                name
            });
            loads.push((place, name));
        }
        self.waiting = waiting;
        let steps = section.steps.clone();
        let statements = if let Some(repeat) = &section.repeat {
            self.loop_section(repeat, section)
        } else {
            let stores = section.stores.iter();
            let stores = stores.map(|&(step, place)| (step, StorePlace::Work(place)));
            self.stores = stores.collect();
            let entries = within(self.program, steps.clone(), self.inlined);
            let statements = self.statements(&entries);
            for &(step, place) in &section.stores {
                self.leave_unnamed(step, place);
            }
            statements
        };
        self.waiting.clear();
        for (step, place) in anew {
            self.steps[step as usize] = Value::Work(place);
        }
        let steps = &self.program.steps[steps.start as usize..steps.end as usize];
        let mut read = steps.iter().flat_map(|step| step.operation.operands());
        SectionBody {
            name,
            loads,
            statements,
            has_literals: read.any(|operand| matches!(operand, Operand::Literal(_))),
            is_fused: is_fused(steps),
        }
    }

    /// Leaves a value in the work array if it has no meaning: other sections name it anew.
    fn leave_unnamed(&mut self, step: u32, place: usize) {
        if self.meaning(step).is_none() {
            self.steps[step as usize] = Value::Work(place);
        }
    }

    /// A loop that stores its results in the work array.
    fn loop_section(&mut self, repeat: &Repeat, section: &Section) -> Vec<Statement> {
        let each = self.loop_of(repeat, Some(section));
        for &(step, place) in &section.stores {
            self.steps[step as usize] = Value::Work(place);
        }
        let copies = section.copies.iter();
        let copies =
            copies.map(|&(from, to)| Statement::Store(StorePlace::Work(to), Value::Work(from)));
        copies.chain([Statement::Loop(each)]).collect()
    }
}

/// Number of times that a section reads each value that it loads. Those that are the same for all iterations of a loop
/// count twice, so that they are read before it.
fn readers(program: &Program, section: &Section) -> HashMap<Shared, usize> {
    let mut readers = HashMap::new();
    let mut read = |operand, count| {
        if let Some(value) = Shared::of(operand) {
            *readers.entry(value).or_default() += count;
        }
    };
    let Some(repeat) = &section.repeat else {
        let steps = &program.steps[section.steps.start as usize..section.steps.end as usize];
        let operands = steps.iter().flat_map(|step| step.operation.operands());
        operands.for_each(|operand| read(operand, 1));
        return readers;
    };
    for operand in repeat.in_no_row(program) {
        read(operand, 2);
    }
    for &operand in repeat.loads.iter().flatten() {
        read(operand, 1);
    }
    readers
}

fn is_fused(steps: &[Step]) -> bool {
    steps.iter().any(|step| step.operation.is_fused())
}
