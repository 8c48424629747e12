//! Stores of results in the arrays of the caller.
//!
//! In: a routine and the names of its results. Out: a statement for each result, or a loop for those that are in a row.

use super::body::{CWriter, place};
use super::declarations::lengths;
use crate::module::Module;
use crate::print::copies::{CopiedBlock, Copies, CopyLoop, at_equal_distances};
use crate::print::expression::subscript;
use crate::schedule::{LONGEST_SCOPE, Routine, Value};
use crate::space::Quantity;

/// Result with its values.
struct ResultArray<'r> {
    name: &'r str,
    lengths: &'r [usize],
    /// Its values in the order of the array; none of those that are stored already.
    values: &'r [Option<&'r Value>],
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
            let own = &routine.results[first..];
            let size = lengths.iter().product::<usize>().min(own.len());
            let values = (0..size).map(|k| {
                let k = match quantity.entity.halves() {
                    Some(_) => self.options.order.place(k),
                    None => k,
                };
                (!routine.stored.contains(&(first + k))).then_some(&own[k])
            });
            let result = ResultArray {
                name,
                lengths: &lengths,
                values: &values.collect::<Vec<_>>(),
            };
            first += size;
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
                let rest: Vec<_> = (0..size).filter(|&k| result.values[k].is_some()).collect();
                return self.store_each(result, &rest, &indices[1]);
            }
        };
        let [rows, columns] = matrix;
        for (number, values) in result.values.chunks(rows * columns).enumerate() {
            let start = number * rows * columns;
            let copies = Copies::of(matrix, |k| values[k]);
            let name = result.array(number, 2);
            for each in &copies.loops {
                self.copy_rows(each, &name, indices);
            }
            let rest: Vec<_> = copies.rest.iter().map(|k| start + k).collect();
            self.store_each(result, &rest, &indices[1]);
            if copies.is_symmetric {
                self.mirror(&name, rows, indices);
            }
        }
    }

    /// Stores values one after the other, or those of a row by a loop that is shorter.
    fn store_each(&mut self, result: &ResultArray<'_>, mut rest: &[usize], index: &String) {
        let row = result.lengths.last().unwrap_or(&1);
        while let Some((&k, others)) = rest.split_first() {
            let end = (k / row + 1) * row;
            let of_row = rest.iter().zip(k..end);
            let of_row = of_row.take_while(|(k, next)| *k == next);
            let copied = InARow::of(of_row.filter_map(|(&k, _)| result.values[k]));
            if let Some(copied) = copied.filter(|_| !self.options.templates) {
                self.copy(&copied, (&result.array(k / row, 1), k % row), index);
                rest = &rest[copied.count..];
                continue;
            }
            if let Some(value) = result.values[k] {
                let value = self.stored(value);
                let place = self.entry(result.name, k, result.lengths);
                self.line(&format!("{place} = {value};"));
            }
            rest = others;
        }
    }

    /// Copies values to rows of a matrix.
    fn copy_rows(&mut self, each: &CopyLoop, matrix: &str, [row, index]: &[String; 2]) {
        let (work, count) = (self.work.clone(), each.rows.len());
        let of = format!("{matrix}[{}]", subscript(each.rows.start, &[(1, row)]));
        self.line(&format!("for (int {row} = 0; {row} < {count}; {row}++) {{"));
        for block in &each.blocks {
            let CopiedBlock {
                column,
                count,
                first,
                down,
                along,
            } = *block;
            if count == 1 {
                let from = subscript(first, &[(down, row)]);
                self.line(&format!("    {of}[{column}] = {work}[{from}];"));
                continue;
            }
            let to = subscript(column, &[(1, index)]);
            let from = subscript(first, &[(down, row), (along, index)]);
            self.line(&format!(
                "    for (int {index} = 0; {index} < {count}; {index}++) {{"
            ));
            self.line(&format!("        {of}[{to}] = {work}[{from}];"));
            self.line("    }");
        }
        for &(column, value) in &each.constant {
            let value = self.stored(&Value::Literal(value));
            self.line(&format!("    {of}[{column}] = {value};"));
        }
        self.line("}");
    }

    /// Copies what a matrix has below its diagonal to the entries above it.
    fn mirror(&mut self, matrix: &str, rows: usize, [row, index]: &[String; 2]) {
        self.line(&format!("for (int {row} = 1; {row} < {rows}; {row}++) {{"));
        self.line(&format!(
            "    for (int {index} = 0; {index} < {row}; {index}++) {{"
        ));
        self.line(&format!(
            "        {matrix}[{index}][{row}] = {matrix}[{row}][{index}];"
        ));
        self.line("    }");
        self.line("}");
    }

    /// Copies values to an array, from an entry on.
    fn copy(&mut self, copied: &InARow, (array, start): (&str, usize), index: &String) {
        let count = copied.count;
        let from = subscript(copied.first, &[(copied.stride, index)]);
        let from = match &copied.from {
            SourceArray::Work => format!("{}[{from}]", self.work),
            SourceArray::Column(table, column) => format!("{table}[{from}][{column}]"),
        };
        self.line(&format!(
            "for (int {index} = 0; {index} < {count}; {index}++) {{"
        ));
        let to = subscript(start, &[(1, index)]);
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
    fn of<'v>(values: impl Iterator<Item = &'v Value> + Clone) -> Option<Self> {
        let from = match values.clone().next()? {
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
        let ([first, stride], count) = at_equal_distances(values.map_while(place))?;
        let is_apart = stride > 1 || matches!(from, SourceArray::Column(..));
        (count >= COPIED && is_apart).then_some(Self {
            from,
            first,
            stride,
            count,
        })
    }
}
