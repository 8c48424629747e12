//! Loops of a routine.
//!
//! In: a repeat of a program, and the naming of its routine. Out: the statements of one iteration, and the table that
//! values which differ between iterations are read from and written to.

use super::{Meaning, Naming, Statement, Value};
use crate::schedule::Operand;
use crate::schedule::blocks::within;
use crate::schedule::repeats::Repeat;

/// Loop over the columns of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Rounds {
    /// Name of the table.
    pub table: String,
    /// Initial rows of the table, with an entry for each iteration.
    pub rows: Vec<Vec<Value>>,
    /// Name of the loop's index, from 0.
    pub round: String,
    /// Names of the values that an iteration reads from the table, row by row.
    pub taken: Vec<String>,
    /// Statements of an iteration.
    pub statements: Vec<Statement>,
    /// Names of the values that an iteration writes to the table, row by row.
    pub left: Vec<String>,
}

impl Rounds {
    /// Number of iterations.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }
}

impl Naming<'_> {
    /// Loop of a repeat.
    pub(super) fn rounds(&mut self, repeat: &Repeat) -> Rounds {
        let [table, round] = [Meaning::Table, Meaning::Round].map(|meaning| self.named(meaning));
        let row = |row: &Vec<Operand>| row.iter().map(|&operand| self.value(operand)).collect();
        let mut rows: Vec<Vec<Value>> = repeat.taken.iter().map(row).collect();
        // Rows that are written and not read.
        let missing = repeat.left.len().saturating_sub(rows.len());
        rows.extend(std::iter::repeat_n(rows[0].clone(), missing));

        let taken: Vec<String> = repeat.taken.iter().map(|_| self.unnamed()).collect();
        let reads = repeat.reads.iter();
        let reads = reads.map(|(&place, &row)| (place, taken[row].clone()));
        self.taken = reads.collect();
        let parts = within(self.program, repeat.first.clone(), &repeat.left);
        let statements = self.statements(&parts);
        self.taken.clear();
        let left = repeat.left.iter().map(|&step| self.name(step)).collect();
        self.leave(repeat, &table);
        Rounds {
            table,
            rows,
            round,
            taken,
            statements,
            left,
        }
    }

    /// Records the places of the results of all iterations in the table.
    fn leave(&mut self, repeat: &Repeat, table: &str) {
        self.steps.truncate(repeat.first.start as usize);
        for round in 0..repeat.rounds as usize {
            for step in repeat.first.clone() {
                // A value that is not stored has no reader.
                let row = repeat.left.iter().position(|&left| left == step);
                let row = row.unwrap_or_default();
                self.steps.push(Value::Entry(table.to_owned(), row, round));
            }
        }
        self.sums.resize(self.steps.len(), None);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::super::tests::of_a_hinge;
    use super::super::{Statement, Stored, Value};
    use crate::schedule::repeats::tests::{HEAD, LENGTH, program};
    use crate::schedule::{Length, Names, Operation, Program, run};

    /// Interpreter of a routine.
    #[derive(Default)]
    struct Written {
        bound: BTreeMap<String, f64>,
        tables: BTreeMap<String, Vec<Vec<f64>>>,
        work: Vec<f64>,
    }

    impl Written {
        fn read(&self, value: &Value) -> f64 {
            match value {
                Value::Literal(value) => *value,
                Value::Name(name) => self.bound[name],
                Value::Waiting(place) => self.work[*place],
                Value::Entry(table, row, round) => self.tables[table][*row][*round],
            }
        }

        fn run(&mut self, statements: &[Statement]) {
            for statement in statements {
                match statement {
                    Statement::Operation(name, operation) => {
                        let value = match operation.clone().map(|value| self.read(&value)) {
                            Operation::Add(a, b) => a + b,
                            Operation::Sub(a, b) => a - b,
                            Operation::Mul(a, b) => a * b,
                            Operation::Neg(a) => -a,
                            Operation::MulSub(a, b, c) => a * b - c,
                            other => unreachable!("{other:?}"),
                        };
                        self.bound.insert(name.clone(), value);
                    }
                    Statement::Block { statements, .. } => self.run(statements),
                    Statement::Rounds(rounds) => {
                        let row = |row: &Vec<Value>| row.iter().map(|of| self.read(of)).collect();
                        let mut table: Vec<Vec<f64>> = rounds.rows.iter().map(row).collect();
                        for round in 0..table[0].len() {
                            for (name, row) in rounds.taken.iter().zip(&table) {
                                self.bound.insert(name.clone(), row[round]);
                            }
                            self.run(&rounds.statements);
                            for (name, row) in rounds.left.iter().zip(&mut table) {
                                row[round] = self.bound[name];
                            }
                        }
                        self.tables.insert(rounds.table.clone(), table);
                    }
                    Statement::Left(place, value) => self.work[*place] = self.read(value),
                    Statement::SinesAndCosines(_) | Statement::Found(..) => {
                        unreachable!("{statement:?}")
                    }
                }
            }
        }
    }

    /// Results of a program with functions of this length, and its number of loops.
    fn results(program: &Program, length: Length) -> (Vec<f64>, usize) {
        let names = Names::beside(&["columns"]);
        let routine = of_a_hinge((program, length), names, Stored::AtTheEnd);
        let mut written = Written::default();
        written.bound.insert("q_1".to_owned(), 0.7);
        written.run(&routine.statements);
        let mut statements = routine.statements.clone();
        if let Some(work) = &routine.work {
            written.work = vec![f64::NAN; work.len];
            for (place, value) in &work.given {
                written.work[*place] = written.read(value);
            }
            for section in &work.sections {
                // A section has only the names that it binds.
                written.bound.clear();
                for (place, name) in &section.taken {
                    written.bound.insert(name.clone(), written.work[*place]);
                }
                written.run(&section.statements);
                statements.extend(section.statements.clone());
            }
        }
        let found = routine.results.iter().map(|result| written.read(result));
        let found = found.collect();
        let in_rounds = |statement: &&Statement| matches!(statement, Statement::Rounds(_));
        (found, statements.iter().filter(in_rounds).count())
    }

    #[test]
    fn rounds_compute_what_all_steps_do_one_after_the_other() {
        // Iterations of one scope, and of several blocks.
        for program in [program(HEAD, LENGTH), program(HEAD, 1000)] {
            let expected = run::<f64>(&program, |_| 0.7);
            for length in [Length::UNBOUNDED, Length::at_most(1000)] {
                assert_eq!(results(&program, length), (expected.clone(), 1));
            }
            // Sections shorter than an iteration hold no loop.
            assert_eq!(results(&program, Length::at_most(50)), (expected, 0));
        }
    }
}
