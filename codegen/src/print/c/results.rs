//! Stores of results in the arrays of the caller.
//!
//! In: a routine and the names of its results. Out: a statement for each result, or a loop for those that are in a row.

use super::body::CWriter;
use super::declarations::lengths;
use crate::module::Module;
use crate::print::copies::Copies;
use crate::schedule::{Routine, Value};
use crate::space::Quantity;

impl CWriter<'_> {
    /// Stores the results that are not stored yet.
    pub(super) fn store_results(
        &mut self,
        routine: &Routine,
        module: &Module,
        results: &[(String, Quantity)],
    ) {
        let [row_index, index] = ["row", "k"].map(|name| self.names.fresh(name));
        let mut first = 0;
        for (name, quantity) in results {
            let lengths = lengths(quantity, &module.spaces);
            let values = &routine.results[first..];
            let size = lengths.iter().product::<usize>().min(values.len());
            let (row, outer) = lengths.split_last().unwrap_or((&1, &[]));
            let has_order = quantity.entity.halves().is_some();
            // In C++, results may be of types with another index.
            let is_array = !has_order && !self.options.templates;
            let mut k = 0;
            if let ([rows, columns], true) = (&*lengths, is_array)
                && size == rows * columns
                && let Some(copies) = Copies::of(&values[..size], *columns)
            {
                self.copy_matrix(&copies, name, &lengths, [&row_index, &index]);
                k = size;
            }
            while k < size {
                let end = size.min((k / row + 1) * row);
                let copied = InARow::of(&values[k..end]).filter(|_| is_array);
                if let Some(copied) = copied {
                    let array = if outer.is_empty() {
                        name.clone()
                    } else {
                        self.entry(name, k / row, outer)
                    };
                    self.copy(&copied, (&array, k % row), &index);
                    k += copied.count;
                    continue;
                }
                if !routine.stored.contains(&(first + k)) {
                    let value = self.stored(&values[k]);
                    let k = if has_order {
                        self.options.order.place(k)
                    } else {
                        k
                    };
                    let place = self.entry(name, k, &lengths);
                    self.line(&format!("{place} = {value};"));
                }
                k += 1;
            }
            first += size;
        }
    }

    /// Copies values to a matrix.
    fn copy_matrix(
        &mut self,
        copies: &Copies<'_>,
        name: &str,
        lengths: &[usize],
        [row, index]: [&str; 2],
    ) {
        let rows = copies.rows;
        self.line(&format!("for (int {row} = 0; {row} < {rows}; {row}++) {{"));
        for block in &copies.blocks {
            let (column, count) = (block.column, block.count);
            let from = format!("{}[{} + {} * {row}", self.work, block.first, block.down);
            if count == 1 {
                self.line(&format!("    {name}[{row}][{column}] = {from}];"));
                continue;
            }
            self.line(&format!(
                "    for (int {index} = 0; {index} < {count}; {index}++) {{"
            ));
            let along = block.along;
            self.line(&format!(
                "        {name}[{row}][{column} + {index}] = {from} + {along} * {index}];"
            ));
            self.line("    }");
        }
        for &(column, value) in &copies.constant {
            let value = self.stored(&Value::Literal(value));
            self.line(&format!("    {name}[{row}][{column}] = {value};"));
        }
        self.line("}");
        for &([of_row, column], value) in &copies.others {
            let value = self.stored(value);
            let place = self.entry(name, of_row * lengths[1] + column, lengths);
            self.line(&format!("{place} = {value};"));
        }
    }

    /// Copies values to an array, from an entry on.
    fn copy(&mut self, copied: &InARow, (array, start): (&str, usize), index: &str) {
        let InARow {
            from,
            first,
            stride,
            count,
        } = copied;
        let from = match from {
            SourceArray::Work => format!("{}[{first} + {stride} * {index}]", self.work),
            SourceArray::Column(table, column) => {
                format!("{table}[{first} + {stride} * {index}][{column}]")
            }
        };
        self.line(&format!(
            "for (int {index} = 0; {index} < {count}; {index}++) {{"
        ));
        self.line(&format!("    {array}[{start} + {index}] = {from};"));
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
