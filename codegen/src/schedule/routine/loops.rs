//! Loops of a routine.
//!
//! In: a repeat of a program, and the naming of its routine. Out: the statements of one iteration, and the table that
//! values which differ between iterations are read from and, outside of sections, written to.

use super::{Meaning, Naming, Statement, Value};
use crate::schedule::Operand;
use crate::schedule::blocks::within;
use crate::schedule::repeats::{Over, Repeat};

/// Loop over the columns of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// Name of the table.
    pub table: String,
    /// Rows of the table that are read, with an entry for each iteration.
    pub rows: Vec<Vec<Value>>,
    /// Name of the loop's index, from 0.
    pub column: String,
    /// Names of the values that an iteration reads from the table, row by row.
    pub loads: Vec<String>,
    /// Statements of an iteration.
    pub statements: Vec<Statement>,
    /// Names of the values that an iteration stores: in the table, row by row, or in the work array.
    pub stores: Vec<String>,
    /// Index of the first of them in the work array, where each is followed by that of all iterations; `None` if they
    /// are stored in the table.
    pub first: Option<usize>,
}

impl Loop {
    /// Number of iterations.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }

    /// Number of rows of the table that are stored and not read.
    #[must_use]
    pub fn unread(&self) -> usize {
        match self.first {
            Some(_) => 0,
            None => self.stores.len().saturating_sub(self.rows.len()),
        }
    }

    /// The rows, and for those that are not read others.
    pub fn all_rows(&self) -> impl Iterator<Item = &Vec<Value>> {
        let unread = self.rows.iter().take(1).cycle().take(self.unread());
        self.rows.iter().chain(unread)
    }
}

impl Naming<'_> {
    /// Loop of a repeat; `first` is the place of its first result in the work array, if they are stored there.
    pub(super) fn loop_of(&mut self, repeat: &Repeat, first: Option<usize>) -> Loop {
        let [table, column] =
            [Meaning::Table, Meaning::LoopIndex].map(|meaning| self.named(meaning));
        let row = |row: &Vec<Operand>| row.iter().map(|&operand| self.value(operand)).collect();
        let rows: Vec<Vec<Value>> = repeat.loads.iter().map(row).collect();
        let loads: Vec<String> = repeat.loads.iter().map(|_| self.unnamed()).collect();
        let reads = repeat.reads.iter();
        let reads = reads.map(|(&place, &row)| (place, loads[row].clone()));
        self.loads = reads.collect();
        self.is_named = repeat.over == Over::Limbs;
        let parts = within(self.program, repeat.first.clone(), &repeat.stores);
        let statements = self.statements(&parts);
        self.loads.clear();
        self.is_named = true;
        let stores = repeat.stores.iter().map(|&step| self.name(step)).collect();
        self.leave(repeat, &table);
        Loop {
            table,
            rows,
            column,
            loads,
            statements,
            stores,
            first,
        }
    }

    /// Records the places of the results of all iterations in the table.
    fn leave(&mut self, repeat: &Repeat, table: &str) {
        self.steps.truncate(repeat.first.start as usize);
        for column in 0..repeat.iterations as usize {
            for step in repeat.first.clone() {
                // A value that is not stored has no reader.
                let row = repeat.stores.iter().position(|&stores| stores == step);
                let row = row.unwrap_or_default();
                self.steps.push(Value::Entry(table.to_owned(), row, column));
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
                Value::Work(place) => self.work[*place],
                Value::Entry(table, row, column) => self.tables[table][*row][*column],
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
                    Statement::Loop(each) => {
                        let row = |row: &Vec<Value>| row.iter().map(|of| self.read(of)).collect();
                        let mut table: Vec<Vec<f64>> = each.all_rows().map(row).collect();
                        let count = each.count();
                        for column in 0..count {
                            for (name, row) in each.loads.iter().zip(&table) {
                                self.bound.insert(name.clone(), row[column]);
                            }
                            self.run(&each.statements);
                            for (row, name) in each.stores.iter().enumerate() {
                                let value = self.bound[name];
                                match each.first {
                                    Some(first) => self.work[first + row * count + column] = value,
                                    None => table[row][column] = value,
                                }
                            }
                        }
                        self.tables.insert(each.table.clone(), table);
                    }
                    Statement::StoreWork(place, value) => self.work[*place] = self.read(value),
                    Statement::SinesAndCosines(_) | Statement::StoreResult(..) => {
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
            for (place, value) in &work.initial {
                written.work[*place] = written.read(value);
            }
            for section in &work.sections {
                // A section has only the names that it binds.
                written.bound.clear();
                for (place, name) in &section.loads {
                    written.bound.insert(name.clone(), written.work[*place]);
                }
                written.run(&section.statements);
                statements.extend(section.statements.clone());
            }
        }
        let found = routine.results.iter().map(|result| written.read(result));
        let found = found.collect();
        let is_loop = |statement: &&Statement| matches!(statement, Statement::Loop(_));
        (found, statements.iter().filter(is_loop).count())
    }

    #[test]
    fn loops_compute_the_same_as_all_steps() {
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
