//! The rounds of a routine, each of which computes the same of other values.
//!
//! In: a repeat of a program, and a routine whose names are being given. Out: statements of one round, and the table
//! through which what differs comes and goes. It never says what is a repeat.

use super::{Meaning, Naming, Statement, Value};
use crate::schedule::Operand;
use crate::schedule::blocks::within;
use crate::schedule::repeats::Repeat;

/// The same statements for each column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Rounds {
    /// The name of the table.
    pub table: String,
    /// What stands there before the first round: rows with an entry for each round.
    pub rows: Vec<Vec<Value>>,
    /// What counts the rounds, from 0.
    pub round: String,
    /// What is taken from the table: the name of each row, from the first on.
    pub taken: Vec<String>,
    /// What is computed.
    pub statements: Vec<Statement>,
    /// What is put into the table instead: the name of what each row then has, from the first on.
    pub left: Vec<String>,
}

impl Rounds {
    /// How many rounds there are: entries of each row.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }
}

impl Naming<'_> {
    /// The rounds of a repeat.
    pub(super) fn rounds(&mut self, repeat: &Repeat) -> Rounds {
        let [table, round] = [Meaning::Table, Meaning::Round].map(|meaning| self.named(meaning));
        let row = |row: &Vec<Operand>| row.iter().map(|&operand| self.value(operand)).collect();
        let mut rows: Vec<Vec<Value>> = repeat.taken.iter().map(row).collect();
        // What is left without being taken has to stand somewhere.
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

    /// Finds the results of all rounds in the table.
    fn leave(&mut self, repeat: &Repeat, table: &str) {
        self.steps.truncate(repeat.first.start as usize);
        for round in 0..repeat.rounds as usize {
            for step in repeat.first.clone() {
                // Nobody reads what is not left.
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

    /// What a language makes of a routine.
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

    /// The results of a program in functions of a length, and how many loops it has.
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
                // A section knows nothing but what it takes.
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
        // Rounds that are one scope, and rounds of several blocks.
        for program in [program(HEAD, LENGTH), program(HEAD, 1000)] {
            let expected = run::<f64>(&program, |_| 0.7);
            for length in [Length::UNBOUNDED, Length::at_most(1000)] {
                assert_eq!(results(&program, length), (expected.clone(), 1));
            }
            // Shorter than a round, a section cannot hold a loop.
            assert_eq!(results(&program, Length::at_most(50)), (expected, 0));
        }
    }
}
