//! Stores of results in the arrays of the caller.
//!
//! In: a routine and the names of its results. Out: a statement for each result, or a loop for those that are in a row.

use std::collections::BTreeSet;

use super::body::{CWriter, place};
use super::declarations::lengths;
use crate::module::Module;
use crate::print::copies::{CopiedBlock, Copies, CopyLoop, index as sum};
use crate::schedule::{LONGEST_SCOPE, Routine, Value};
use crate::space::Quantity;

/// Result with its values.
struct ResultArray<'r> {
    name: &'r str,
    lengths: &'r [usize],
    /// Its values in the order of the array.
    values: &'r [Value],
    /// Indices of those that are stored already.
    stored: &'r BTreeSet<usize>,
}

impl ResultArray<'_> {
    /// The array with this number among those over its last dimensions.
    fn array(&self, number: usize, dimensions: usize) -> String {
        match &self.lengths[..self.lengths.len() - dimensions] {
            [] => self.name.to_owned(),
            outer => place(self.name, number, outer),
        }
    }
}

impl CWriter<'_> {
    /// Stores the results that are not stored yet.
    pub(super) fn store_results(
        &mut self,
        routine: &Routine,
        module: &Module,
        results: &[(String, Quantity)],
    ) {
        let indices = ["row", "k"].map(|name| self.names.fresh(name));
        let mut first = 0;
        for (name, quantity) in results {
            let lengths = lengths(quantity, &module.spaces);
            let mut values = routine.results[first..].to_vec();
            values.truncate(lengths.iter().product());
            let stored = routine.stored.range(first..first + values.len());
            let stored = stored.map(|stored| stored - first).collect();
            first += values.len();
            if quantity.entity.halves().is_some() {
                let order = self.options.order;
                let from = (0..values.len()).map(|place| values[order.place(place)].clone());
                values = from.collect();
            }
            let result = ResultArray {
                name,
                lengths: &lengths,
                values: &values,
                stored: &stored,
            };
            self.store_result(&result, &indices);
        }
    }

    fn store_result(&mut self, result: &ResultArray<'_>, indices: &[String; 2]) {
        let size = result.values.len();
        // In C++, results may be of types with another index.
        let is_array = !self.options.templates;
        let matrix = match result.lengths {
            [.., rows, columns] if is_array && size > LONGEST_SCOPE => [*rows, *columns],
            _ => {
                let rest: Vec<_> = (0..size).filter(|k| !result.stored.contains(k)).collect();
                return self.store_each(result, &rest, &indices[1]);
            }
        };
        let [rows, columns] = matrix;
        for (number, values) in result.values.chunks(rows * columns).enumerate() {
            let start = number * rows * columns;
            let copies = Copies::of(values, columns, |k| result.stored.contains(&(start + k)));
            let matrix = result.array(number, 2);
            for each in &copies.loops {
                self.copy_rows(each, &matrix, indices);
            }
            let rest: Vec<_> = copies.rest.iter().map(|k| start + k).collect();
            self.store_each(result, &rest, &indices[1]);
        }
    }

    /// Stores values one after the other, or those of a row by a loop that is shorter.
    fn store_each(&mut self, result: &ResultArray<'_>, mut rest: &[usize], index: &str) {
        let row = result.lengths.last().unwrap_or(&1);
        while let Some((&k, others)) = rest.split_first() {
            let end = (k / row + 1) * row;
            let of_row = rest.iter().zip(k..end);
            let count = of_row.take_while(|(k, next)| *k == next).count();
            let copied = InARow::of(&result.values[k..k + count]);
            if let Some(copied) = copied.filter(|_| !self.options.templates) {
                self.copy(&copied, (&result.array(k / row, 1), k % row), index);
                rest = &rest[copied.count..];
                continue;
            }
            let value = self.stored(&result.values[k]);
            let place = self.entry(result.name, k, result.lengths);
            self.line(&format!("{place} = {value};"));
            rest = others;
        }
    }

    /// Copies values to rows of a matrix.
    fn copy_rows(&mut self, each: &CopyLoop, matrix: &str, [row, index]: &[String; 2]) {
        let (work, count) = (&self.work, each.rows.len());
        let of = format!("{matrix}[{}]", sum(each.rows.start, &[(1, row)]));
        let mut lines = vec![format!("for (int {row} = 0; {row} < {count}; {row}++) {{")];
        for block in &each.blocks {
            let CopiedBlock {
                column,
                count,
                first,
                down,
                along,
            } = *block;
            if count == 1 {
                let from = sum(first, &[(down, row)]);
                lines.push(format!("    {of}[{column}] = {work}[{from}];"));
                continue;
            }
            let to = sum(column, &[(1, index)]);
            let from = sum(first, &[(down, row), (along, index)]);
            lines.extend([
                format!("    for (int {index} = 0; {index} < {count}; {index}++) {{"),
                format!("        {of}[{to}] = {work}[{from}];"),
                "    }".to_owned(),
            ]);
        }
        for line in lines {
            self.line(&line);
        }
        for &(column, value) in &each.constant {
            let value = self.stored(&Value::Literal(value));
            self.line(&format!("    {of}[{column}] = {value};"));
        }
        self.line("}");
    }

    /// Copies values to an array, from an entry on.
    fn copy(&mut self, copied: &InARow, (array, start): (&str, usize), index: &str) {
        let count = copied.count;
        let from = sum(copied.first, &[(copied.stride, index)]);
        let from = match &copied.from {
            SourceArray::Work => format!("{}[{from}]", self.work),
            SourceArray::Column(table, column) => format!("{table}[{from}][{column}]"),
        };
        self.line(&format!(
            "for (int {index} = 0; {index} < {count}; {index}++) {{"
        ));
        let to = sum(start, &[(1, index)]);
        self.line(&format!("    {array}[{to}] = {from};"));
        self.line("}");
    }
}

/// Minimum number of values that a loop copies.
const COPIED: usize = 8;

/// Values that a loop copies, at equal distances in the work array or in one column of a loop's table. Neighbours in
/// the array are none: compilers would call `memcpy`, which firmware may lack.
struct InARow {
    from: SourceArray,
    first: usize,
    stride: usize,
    count: usize,
}

/// Array that values in a row are read from.
enum SourceArray {
    Work,
    Column(String, usize),
}

impl InARow {
    /// The longest stretch from the first value on, if a loop is shorter.
    fn of(values: &[Value]) -> Option<Self> {
        let from = match values.first()? {
            Value::Work(_) => SourceArray::Work,
            Value::Entry(table, _, column) => SourceArray::Column(table.clone(), *column),
            _ => return None,
        };
        let place = |value: &Value| match (value, &from) {
            (Value::Work(place), SourceArray::Work) => Some(*place),
            (Value::Entry(of, row, column), SourceArray::Column(table, own)) => {
                (of == table && column == own).then_some(*row)
            }
            _ => None,
        };
        let mut places = values.iter().map_while(place);
        let first = places.next()?;
        let stride = places.next()?.checked_sub(first)?;
        let places = values.iter().map_while(place).enumerate();
        let count = places
            .take_while(|(k, place)| *place == first + k * stride)
            .count();
        let is_apart = stride > 1 || matches!(from, SourceArray::Column(..));
        (count >= COPIED && is_apart).then_some(Self {
            from,
            first,
            stride,
            count,
        })
    }
}
