//! Loops of a routine.
//!
//! In: a repeat of a program, and the naming of its routine. Out: the statements of one iteration, and the rows that
//! values which differ between iterations are read from and written to: of the loop's own tables, of that of an earlier
//! loop, which has stored them, or of the work array.

#[cfg(test)]
mod tests;

use super::{Meaning, Naming, Statement, StorePlace, Value};
use crate::schedule::Operand;
use crate::schedule::blocks::within;
use crate::schedule::repeats::{Over, Repeat};
use crate::schedule::sections::Section;

/// Loop over the columns of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct RoutineLoop {
    /// Number of iterations.
    pub count: usize,
    /// Name of the table that iterations read; none is needed if it has no rows.
    pub table: String,
    /// Its rows, with a value for each iteration.
    pub rows: Vec<Vec<Value>>,
    /// Table that iterations write; none in a section.
    pub found: Option<LoopTable>,
    /// Name of the loop's index, from 0.
    pub index: String,
    /// Names of the values that an iteration reads several times, and the row of each.
    pub loads: Vec<(String, Cells)>,
    /// Statements of an iteration, with stores to rows.
    pub statements: Vec<Statement>,
}

/// Table that the iterations of a loop write.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopTable {
    /// Its name.
    pub table: String,
    /// Number of its rows.
    pub height: usize,
    /// A value that its entries have before the loop, in languages in which they need one.
    pub before: Value,
}

/// Values of all iterations, one after the other.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Row with this index of a table, which may be that of an earlier loop.
    Table(String, usize),
    /// Entries of the work array from this index on.
    Work(usize),
}

impl Cells {
    /// Row of values that are stored like one.
    fn of(values: &[Value]) -> Option<Self> {
        let Value::Entry(table, row, _) = values.first()? else {
            return None;
        };
        let mut values = values.iter().enumerate();
        let is_row = values.all(|(column, value)| {
            matches!(value, Value::Entry(of, at, entry) if (of, at, *entry) == (table, row, column))
        });
        is_row.then(|| Self::Table(table.clone(), *row))
    }
}

impl Naming<'_> {
    /// Loop of a repeat, in a section or in none.
    pub(super) fn loop_of(&mut self, repeat: &Repeat, section: Option<&Section>) -> RoutineLoop {
        self.loops += 1;
        let [table, found] =
            [Meaning::Table, Meaning::Found].map(|of_loop| self.named(of_loop(self.loops)));
        let index = self.index();
        let mut rows = Vec::new();
        let mut readers = vec![0; repeat.loads.len()];
        for &row in repeat.reads.values() {
            readers[row] += 1;
        }
        let mut loads = Vec::new();
        let values = repeat.loads.iter().enumerate().map(|(at, operands)| {
            let waiting = section.and_then(|section| section.rows[at]);
            let row = waiting.map_or_else(|| self.row(&table, operands, &mut rows), Cells::Work);
            if readers[at] == 1 {
                return Value::Cell(row, index.clone());
            }
            let name = self.unnamed();
            loads.push((name.clone(), row));
            Value::Name(name)
        });
        let values: Vec<Value> = values.collect();
        let reads = repeat.reads.iter();
        let reads = reads.map(|(&place, &row)| (place, values[row].clone()));
        self.loads = reads.collect();
        self.is_named = repeat.over == Over::Limbs;
        let first = section.map(|section| section.stores.first().map_or(0, |&(_, place)| place));
        let count = repeat.iterations as usize;
        let stores = repeat.stores.iter().enumerate().map(|(at, &step)| {
            let row = first.map(|first| Cells::Work(first + at * count));
            let row = row.unwrap_or_else(|| Cells::Table(found.clone(), at));
            (step, StorePlace::Cell(row, index.clone()))
        });
        self.stores = stores.collect();
        let entries = within(self.program, repeat.first.clone(), self.inlined);
        let statements = self.statements(&entries);
        self.stores.clear();
        self.loads.clear();
        self.is_named = true;
        self.leave(repeat, &found);
        let before = repeat.loads.first().and_then(|row| row.first());
        let before = before.map(|&operand| self.value(operand));
        let of_stores = |before| LoopTable {
            table: found,
            height: repeat.stores.len(),
            before,
        };
        let found = before.filter(|_| section.is_none()).map(of_stores);
        RoutineLoop {
            count,
            table,
            rows,
            found,
            index,
            loads,
            statements,
        }
    }

    /// Name of the index of a loop.
    fn index(&mut self) -> String {
        let known = self.index.take();
        let index = known.unwrap_or_else(|| self.named(Meaning::LoopIndex));
        self.index = Some(index.clone());
        index
    }

    /// Row of values that an earlier loop has stored like one, or a new row of a table.
    fn row(&self, table: &str, operands: &[Operand], rows: &mut Vec<Vec<Value>>) -> Cells {
        let values: Vec<Value> = operands.iter().map(|&of| self.value(of)).collect();
        Cells::of(&values).unwrap_or_else(|| {
            rows.push(values);
            Cells::Table(table.to_owned(), rows.len() - 1)
        })
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
    }
}
