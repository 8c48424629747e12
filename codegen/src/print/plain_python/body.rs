//! Statements of Python for a routine.
//!
//! In: statements. Out: an assignment for each. Nothing is an array: every name is a number.

use std::fmt::Write;

use super::names::{LIBRARY, SIGN};
use crate::print::expression::{Spelling, spelled};
use crate::print::review::filled;
use crate::print::walk::Language;
use crate::schedule::{Angle, Cells, LoopTable, Operation, RoutineLoop, StorePlace, Value};

/// Indentation of a level.
const LEVEL: &str = "    ";

/// Printer of routines.
#[derive(Default)]
pub(super) struct PythonWriter {
    pub(super) text: String,
    /// Number of loops around the statement.
    loops: usize,
}

impl PythonWriter {
    pub(super) fn line(&mut self, statement: &str) {
        let indent = LEVEL.repeat(1 + self.loops);
        for line in statement.lines() {
            // Writing to a string cannot fail.
            let _ = writeln!(self.text, "{indent}{line}");
        }
    }

    fn bind(&mut self, name: &str, value: &str) {
        self.line(&format!("{name} = {value}"));
    }
}

/// The shortest decimal of a number.
pub(super) fn literal(value: f64) -> String {
    format!("{value:?}")
}

/// Items in brackets, as many on a line as fit.
pub(super) fn list(items: &[String]) -> String {
    filled(("[", " "), items, "]")
}

impl Spelling for PythonWriter {
    type Text = String;

    fn read(&self, value: &Value) -> String {
        match value {
            Value::Literal(value) => literal(*value),
            Value::Name(name) => name.clone(),
            Value::Entry(table, row, column) => format!("{table}[{row}][{column}]"),
            Value::Cell(row, column) => cell(row, column),
            Value::Operation(operation) => spelled(self, operation),
            Value::Work(_) => unreachable!("functions of Python have no sections"),
        }
    }

    fn root(&self, a: &String) -> String {
        format!("{LIBRARY}.sqrt({a})")
    }

    fn sign(&self, a: &String) -> String {
        format!("{SIGN}({a}, {LIBRARY})")
    }
}

impl Language for PythonWriter {
    fn operation(&mut self, name: &str, operation: &Operation<Value>) {
        let value = spelled(self, operation);
        self.bind(name, &value);
    }

    fn sines_and_cosines(&mut self, angles: &[Angle]) {
        for angle in angles {
            let of = self.read(&angle.value);
            for (name, function) in [(&angle.sine, "sin"), (&angle.cosine, "cos")] {
                if let Some(name) = name {
                    self.bind(name, &format!("{LIBRARY}.{function}({of})"));
                }
            }
        }
    }

    fn put(&mut self, place: &StorePlace, value: &Value) {
        let [place, value] = [&place.value(), value].map(|of| self.read(of));
        self.bind(&place, &value);
    }

    fn store(&mut self, _: usize, _: &Value) {
        unreachable!("results of Python are returned at the end");
    }

    fn begin_loop(&mut self, each: &RoutineLoop) {
        let (index, count) = (&each.index, each.count);
        if !each.rows.is_empty() {
            let rows = each.rows.iter().map(|row| {
                let row: Vec<String> = row.iter().map(|value| self.read(value)).collect();
                list(&row)
            });
            let text = nested(&rows.collect::<Vec<_>>());
            self.bind(&each.table, &text);
        }
        if let Some(LoopTable { table, height, .. }) = &each.found {
            self.bind(
                table,
                &format!("[[None] * {count} for _ in range({height})]"),
            );
        }
        self.line(&format!("for {index} in range({count}):"));
        self.loops += 1;
        for (name, row) in &each.loads {
            self.bind(name, &cell(row, index));
        }
    }

    fn end_loop(&mut self, _: &RoutineLoop) {
        self.loops -= 1;
    }
}

/// `columns[3][column]`.
fn cell(row: &Cells, column: &str) -> String {
    match row {
        Cells::Table(table, row) => format!("{table}[{row}][{column}]"),
        Cells::Work(_) => unreachable!("functions of Python have no sections"),
    }
}

/// Rows in brackets, each on lines of its own.
pub(super) fn nested(rows: &[String]) -> String {
    let mut text = "[\n".to_owned();
    for row in rows {
        for line in row.lines() {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{LEVEL}{line}");
        }
        text.truncate(text.trim_end().len());
        text.push_str(",\n");
    }
    text + "]"
}
