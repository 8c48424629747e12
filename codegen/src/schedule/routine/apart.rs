//! Sections of a long routine, each a function of its own.
//!
//! In: the sections of a program, and the naming of its routine. Out: the routine, with the values that each section
//! reads from the work array, computes, and stores there.

use std::collections::BTreeSet;

use super::{Entries, Naming, Routine, Statement, Value};
use crate::schedule::blocks::{before, within};
use crate::schedule::repeats::Repeat;
use crate::schedule::sections::{Section, Sections};
use crate::schedule::{Operand, Step};
use crate::space::Variable;

/// Sections of a routine and their work array.
#[derive(Clone, Debug, PartialEq)]
pub struct Work {
    /// Name of the work array.
    pub name: String,
    /// Length of the work array.
    pub len: usize,
    /// Index and value of the entries that are stored before the first section.
    pub given: Vec<(usize, Value)>,
    /// Sections in execution order.
    pub sections: Vec<Apart>,
}

/// Section: a function of the work array alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Apart {
    /// Name of the function.
    pub name: String,
    /// Indices of the entries that it reads, and the names that they get.
    pub taken: Vec<(usize, String)>,
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
        let mut statements = self.statements(&before(program));
        statements.extend(self.sines_and_cosines());
        let given = sections.given.iter();
        let given = given.map(|&(value, place)| (place, self.value(value.operand())));
        let given = given.collect();
        let each = sections.sections.iter().zip(1..);
        let each = each.map(|(section, number)| self.apart(section, number));
        let each = each.collect();
        let results = program.results.iter().zip(&sections.results);
        let results = results.map(|(&result, place)| match place {
            Some(place) => Value::Waiting(*place),
            None => self.value(result),
        });
        let results: Vec<Value> = results.collect();
        Routine {
            arguments,
            fields,
            statements,
            work: Some(Work {
                name,
                len: sections.work,
                given,
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

    fn apart(&mut self, section: &Section, number: usize) -> Apart {
        let name = self.names.fresh(&format!("section_{number}"));
        let taken = section.taken.iter().map(|&(value, place)| {
            let Value::Name(name) = self.value(value.operand()) else {
                unreachable!("what waits has a name");
            };
            (place, name)
        });
        let taken = taken.collect();
        let steps = section.steps.clone();
        let statements = if let Some(repeat) = &section.repeat {
            self.rounds_apart(repeat, &section.left)
        } else {
            self.left = section.left.iter().copied().collect();
            self.statements(&within(self.program, steps.clone(), &[]))
        };
        let steps = &self.program.steps[steps.start as usize..steps.end as usize];
        let mut read = steps.iter().flat_map(|step| step.operation.operands());
        Apart {
            name,
            taken,
            statements,
            has_literals: read.any(|operand| matches!(operand, Operand::Literal(_))),
            is_fused: is_fused(steps),
        }
    }

    /// A loop, and the stores of its results in the work array.
    fn rounds_apart(&mut self, repeat: &Repeat, left: &[(u32, usize)]) -> Vec<Statement> {
        let mut statements = vec![Statement::Rounds(self.rounds(repeat))];
        for &(step, place) in left {
            let name = self.unnamed();
            let step = &mut self.steps[step as usize];
            // Other sections bind it to a name.
            let value = std::mem::replace(step, Value::Name(name));
            statements.push(Statement::Left(place, value));
        }
        statements
    }
}

fn is_fused(steps: &[Step]) -> bool {
    steps.iter().any(|step| step.operation.is_fused())
}
