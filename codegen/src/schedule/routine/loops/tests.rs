//! Routines with loops compute the same bits as their programs.

use std::cell::Cell;
use std::collections::BTreeMap;

use super::{Cells, LoopTable, RoutineLoop};
use crate::expression::{Arithmetic, Input};
use crate::schedule::limbs::tests::{COMMON, limbs, program as of_limbs};
use crate::schedule::repeats::tests::{HEAD, LENGTH, program as of_columns};
use crate::schedule::routine::{Routine, Statement, StorePlace, Stored, Value};
use crate::schedule::{Length, Names, Operand, Operation, Program, Readable, Step, run};
use crate::space::{Entry, Kind, Limbs, Spaces, Variable};

/// Number of coordinates and of velocities.
const COUNT: usize = 9;

fn input(input: Input) -> f64 {
    match input {
        Input::Variable(Variable::Q, k) => 0.7 - f64::from(k) / 8.0,
        Input::Variable(_, k) => 0.3 + f64::from(k) / 7.0,
        Input::Parameter(..) => unreachable!("no program has fields"),
    }
}

/// Interpreter of a routine.
#[derive(Default)]
struct Written {
    bound: BTreeMap<String, f64>,
    tables: BTreeMap<String, Vec<Vec<f64>>>,
    work: Vec<f64>,
    /// Iterations that run, by the names of their indices.
    indices: BTreeMap<String, usize>,
    /// Name of the table of the loop that runs.
    own: String,
    /// Number of loops that have run.
    loops: usize,
    /// Number of values that iterations have read from other rows than those of their own table.
    handed_on: Cell<usize>,
}

impl Written {
    fn read(&self, value: &Value) -> f64 {
        match value {
            Value::Literal(value) => *value,
            Value::Name(name) => self.bound[name],
            Value::Work(place) => self.work[*place],
            Value::Entry(table, row, column) => self.tables[table][*row][*column],
            Value::Cell(row, column) => self.cell(row, self.indices[column]),
            Value::Operation(operation) => self.value(operation),
        }
    }

    fn cell(&self, row: &Cells, column: usize) -> f64 {
        let is_own = matches!(row, Cells::Table(table, _) if *table == self.own);
        self.handed_on
            .set(self.handed_on.get() + usize::from(!is_own));
        match row {
            Cells::Table(table, row) => self.tables[table][*row][column],
            Cells::Work(first) => self.work[first + column],
        }
    }

    fn store(&mut self, row: &Cells, column: usize, value: f64) {
        match row {
            Cells::Table(table, row) => {
                let table = self.tables.get_mut(table).expect("a table of a loop");
                table[*row][column] = value;
            }
            Cells::Work(first) => self.work[first + column] = value,
        }
    }

    fn repeat(&mut self, each: &RoutineLoop) {
        self.loops += 1;
        let row = |row: &Vec<Value>| row.iter().map(|of| self.read(of)).collect();
        let table: Vec<Vec<f64>> = each.rows.iter().map(row).collect();
        self.tables.insert(each.table.clone(), table);
        if let Some(LoopTable { table, height, .. }) = &each.found {
            let unknown = vec![vec![f64::NAN; each.count]; *height];
            self.tables.insert(table.clone(), unknown);
        }
        self.own.clone_from(&each.table);
        for column in 0..each.count {
            self.indices.insert(each.index.clone(), column);
            for (name, row) in &each.loads {
                let value = self.cell(row, column);
                self.bound.insert(name.clone(), value);
            }
            self.run(&each.statements);
        }
    }

    fn value(&self, operation: &Operation<Value>) -> f64 {
        match operation.clone().map(|value| self.read(&value)) {
            Operation::Add(a, b) => a + b,
            Operation::Sub(a, b) => a - b,
            Operation::Mul(a, b) => a * b,
            Operation::Div(a, b) => a / b,
            Operation::Neg(a) => -a,
            Operation::MulAdd(a, b, c) => Arithmetic::mul_add(a, b, c),
            Operation::MulSub(a, b, c) => Arithmetic::mul_add(a, b, -c),
            Operation::NegMulAdd(a, b, c) => Arithmetic::mul_add(-a, b, c),
            other => unreachable!("{other:?}"),
        }
    }

    fn run(&mut self, statements: &[Statement]) {
        for statement in statements {
            match statement {
                Statement::Operation(name, operation) => {
                    let value = self.value(operation);
                    self.bound.insert(name.clone(), value);
                }
                Statement::SinesAndCosines(angles) => {
                    for angle in angles {
                        let (sine, cosine) = Arithmetic::sin_cos(self.read(&angle.value));
                        let names = [(&angle.sine, sine), (&angle.cosine, cosine)];
                        for (name, value) in names {
                            self.bound.extend(name.clone().map(|name| (name, value)));
                        }
                    }
                }
                Statement::Block { statements, .. } => self.run(statements),
                Statement::Loop(each) => self.repeat(each),
                Statement::Store(StorePlace::Work(place), value) => {
                    self.work[*place] = self.read(value);
                }
                Statement::Store(StorePlace::Cell(row, index), value) => {
                    self.store(row, self.indices[index], self.read(value));
                }
                Statement::StoreResult(..) => unreachable!("{statement:?}"),
            }
        }
    }

    /// Runs a routine on the values of `input`; a section has only the names that it binds.
    fn of(routine: &Routine) -> Self {
        let mut written = Self::default();
        for (variable, names) in &routine.arguments {
            for (k, name) in (0_u16..).zip(names) {
                let value = input(Input::Variable(*variable, k));
                written.bound.extend(name.clone().map(|name| (name, value)));
            }
        }
        written.run(&routine.statements);
        let Some(work) = &routine.work else {
            return written;
        };
        written.work = vec![f64::NAN; work.len];
        for (place, value) in &work.initial {
            written.work[*place] = written.read(value);
        }
        for section in &work.sections {
            written.bound.clear();
            for (place, name) in &section.loads {
                written.bound.insert(name.clone(), written.work[*place]);
            }
            written.run(&section.statements);
        }
        written
    }
}

/// Results of a program with functions of this length as bits, its number of loops, and how often iterations read what
/// is in no table of their own.
fn results(program: &Program, limbs: &[Limbs], length: Length) -> (Vec<u64>, usize, usize) {
    let entry = || Entry {
        name: "joint".to_owned(),
        kind: Kind::Rotation,
        range: None,
    };
    let spaces = Spaces {
        coordinates: (0..COUNT).map(|_| entry()).collect(),
        velocities: (0..COUNT).map(|_| entry()).collect(),
        ..Spaces::default()
    };
    let readable = Readable {
        arguments: &[Variable::Q, Variable::Qd],
        spaces: &spaces,
        limbs,
        fields: &[],
    };
    let names = Names::beside(&["columns"]);
    let routine = Routine::of((program, length), &readable, names, Stored::AtTheEnd);
    let written = Written::of(&routine);
    let found = routine.results.iter().map(|result| written.read(result));
    let found = found.map(f64::to_bits).collect();
    (found, written.loops, written.handed_on.get())
}

fn expected(program: &Program) -> Vec<u64> {
    let results = run::<f64>(program, input);
    results.into_iter().map(f64::to_bits).collect()
}

#[test]
fn loops_over_columns_compute_the_same_as_all_steps() {
    // Iterations of one scope, and of several blocks.
    for program in [of_columns(HEAD, LENGTH), of_columns(HEAD, 1000)] {
        let expected = expected(&program);
        let (found, loops, _) = results(&program, &[], Length::UNBOUNDED);
        assert_eq!((found, loops), (expected.clone(), 1));
        let (found, loops, _) = results(&program, &[], Length::at_most(1000));
        assert_eq!(found, expected);
        assert!(loops >= 1);
        // Sections shorter than an iteration hold parts of it.
        let (found, loops, _) = results(&program, &[], Length::at_most(50));
        assert_eq!(found, expected);
        assert!(loops > 1);
    }
}

/// A matrix times columns, with more entries than a loop may read.
fn product() -> Program {
    const ROWS: u32 = 20;
    const TERMS: u32 = 20;
    const COLUMNS: u32 = 6;
    let q = Operand::Input(Input::Variable(Variable::Q, 0));
    let [entries, matrix] = [TERMS * COLUMNS, ROWS * TERMS];
    let mut operations = vec![Operation::Neg(q)];
    // Entries of the columns, then those of the matrix.
    operations.extend((1..entries + matrix).map(|k| {
        let other = Operand::Input(Input::Variable(
            Variable::Qd,
            u16::try_from(k % 9).expect("few"),
        ));
        Operation::MulAdd(Operand::Literal(0.5), Operand::Step(k - 1), other)
    }));
    let mut results = Vec::new();
    for column in 0..COLUMNS {
        for row in 0..ROWS {
            for term in 0..TERMS {
                let last = u32::try_from(operations.len() - 1).expect("few steps");
                let entry = Operand::Step(term * COLUMNS + column);
                let factor = Operand::Step(entries + row * TERMS + term);
                let sum = Operand::Step(last);
                operations.push(match (term, (7 * row + 3 * term) % 5) {
                    (0, _) => Operation::Mul(factor, entry),
                    (_, 0 | 2) => Operation::NegMulAdd(factor, entry, sum),
                    _ => Operation::MulAdd(factor, entry, sum),
                });
            }
            let last = u32::try_from(operations.len() - 1).expect("few steps");
            results.push(Operand::Step(last));
        }
    }
    let steps = operations.into_iter().map(|operation| Step {
        label: None,
        operation,
    });
    Program {
        steps: steps.collect(),
        results,
        ..Program::default()
    }
}

/// A loop that reads more values than compilers can compare in reasonable time is cut; what its parts read by columns is
/// copied once.
#[test]
fn parts_of_a_loop_share_the_rows_that_they_read() {
    let program = product();
    let expected = expected(&program);
    let whole = results(&program, &[], Length::UNBOUNDED);
    assert_eq!(whole, (expected.clone(), 1, 0));
    let (found, loops, handed_on) = results(&program, &[], Length::at_most(500));
    assert_eq!(found, expected);
    assert!(loops > 1);
    // 20 rows, each read by six iterations of two loops at least.
    assert!(handed_on >= 240, "{handed_on}");
}

#[test]
fn loops_over_limbs_read_what_earlier_ones_have_stored() {
    for (count, seed) in [(2, 1), (2, 2), (3, 3), (4, 4)] {
        let (program, limbs) = (of_limbs(count, seed), [limbs(count)]);
        let expected = expected(&program);
        for (length, loops) in [(Length::UNBOUNDED, 2), (Length::at_most(COMMON / 2), 6)] {
            let (found, is, handed_on) = results(&program, &limbs, length);
            assert_eq!(found, expected);
            assert!(is >= loops && handed_on > 30 * count, "{is}, {handed_on}");
        }
    }
}
