//! Matrices of results that loops copy.
//!
//! In: the values of a matrix, by rows. Out: blocks of it whose values stand at equal distances in the work array, both
//! along rows and along columns, and all other values. Loops over columns of a program store such blocks.
//!
//! Compilers compare all copies of a function with each other, and thousands take them seconds.

use crate::schedule::Value;

/// Minimum number of rows.
const ROWS: usize = 8;

/// Copies that make up a matrix.
pub(super) struct Copies<'v> {
    /// Number of rows.
    pub rows: usize,
    /// Blocks of all rows.
    pub blocks: Vec<CopiedBlock>,
    /// Columns that have the same literal in all rows.
    pub constant: Vec<(usize, f64)>,
    /// All other values, with row and column.
    pub others: Vec<([usize; 2], &'v Value)>,
}

/// Columns whose values stand at equal distances in the work array, in all rows.
pub(super) struct CopiedBlock {
    /// First column.
    pub column: usize,
    /// Number of columns.
    pub count: usize,
    /// Index of the value in the first row and column.
    pub first: usize,
    /// Distance of neighbours in a column.
    pub down: usize,
    /// Distance of neighbours in a row.
    pub along: usize,
}

impl<'v> Copies<'v> {
    /// Copies of a matrix with rows of this length, if there are blocks.
    pub fn of(values: &'v [Value], columns: usize) -> Option<Self> {
        let rows = values.len() / columns.max(1);
        if rows < ROWS {
            return None;
        }
        let mut copies = Self {
            rows,
            blocks: Vec::new(),
            constant: Vec::new(),
            others: Vec::new(),
        };
        for column in 0..columns {
            let entries = values.iter().skip(column).step_by(columns);
            if let Some([first, down]) = in_a_row(entries.clone()) {
                copies.place(column, first, down);
                continue;
            }
            match values[column] {
                Value::Literal(value) if entries.clone().all(|entry| *entry == values[column]) => {
                    copies.constant.push((column, value));
                }
                _ => {
                    let entries = entries.enumerate();
                    let entries = entries.map(|(row, value)| ([row, column], value));
                    copies.others.extend(entries);
                }
            }
        }
        // Neighbours in both arrays are none: compilers would call `memcpy`, which firmware may lack.
        let is_apart = |block: &CopiedBlock| block.along != 1 || block.count == 1;
        let any = !copies.blocks.is_empty() && columns > 1;
        (any && copies.blocks.iter().all(is_apart)).then_some(copies)
    }

    /// Adds a column, to the last block if it continues that.
    fn place(&mut self, column: usize, first: usize, down: usize) {
        if let Some(last) = self.blocks.last_mut()
            && last.column + last.count == column
            && last.down == down
            && let Some(distance) = first.checked_sub(last.first)
        {
            if last.count == 1 {
                last.along = distance;
            }
            if distance == last.count * last.along {
                last.count += 1;
                return;
            }
        }
        self.blocks.push(CopiedBlock {
            column,
            count: 1,
            first,
            down,
            along: 0,
        });
    }
}

/// First index and distance of values that stand at equal distances in the work array.
fn in_a_row<'v>(values: impl Iterator<Item = &'v Value>) -> Option<[usize; 2]> {
    let mut places = values.map(|value| match value {
        Value::Work(place) => Some(*place),
        _ => None,
    });
    let first = places.next()??;
    let distance = places.next()??.checked_sub(first)?;
    let mut places = places.zip(2..);
    let all = places.all(|(place, row)| place == Some(first + row * distance));
    (all && distance > 0).then_some([first, distance])
}

#[cfg(test)]
mod tests {
    use super::Copies;
    use crate::schedule::Value;

    /// 8 rows: zeros, an entry each of two blocks, and one that is apart in one row.
    fn matrix() -> Vec<Value> {
        let row = |row: usize| {
            let apart = if row == 3 { 999 } else { 300 + row };
            let [a, b, c] = [100 + row, 120 + row, 200 + 2 * row].map(Value::Work);
            [Value::Literal(0.0), a, b, c, Value::Work(apart)]
        };
        (0..8).flat_map(row).collect()
    }

    #[test]
    fn blocks_have_equal_distances_in_all_rows() {
        let values = matrix();
        let copies = Copies::of(&values, 5).expect("blocks");
        let blocks = copies.blocks.iter();
        let blocks = blocks.map(|it| [it.column, it.count, it.first, it.down, it.along]);
        let blocks: Vec<_> = blocks.collect();
        assert_eq!(blocks, [[1, 2, 100, 1, 20], [3, 1, 200, 2, 0]]);
        assert_eq!(copies.constant, [(0, 0.0)]);
        let others: Vec<_> = copies.others.iter().map(|(place, _)| *place).collect();
        assert_eq!(others, [0, 1, 2, 3, 4, 5, 6, 7].map(|row| [row, 4]));
    }

    #[test]
    fn every_entry_is_copied_once() {
        let values = matrix();
        let copies = Copies::of(&values, 5).expect("blocks");
        let mut found = vec![None; values.len()];
        let mut set = |row: usize, column: usize, value: Value| {
            assert_eq!(found[5 * row + column].replace(value), None);
        };
        for row in 0..copies.rows {
            for block in &copies.blocks {
                for k in 0..block.count {
                    let place = block.first + block.down * row + block.along * k;
                    set(row, block.column + k, Value::Work(place));
                }
            }
            for &(column, value) in &copies.constant {
                set(row, column, Value::Literal(value));
            }
        }
        for ([row, column], value) in copies.others {
            set(row, column, value.clone());
        }
        let found: Vec<_> = found.into_iter().flatten().collect();
        assert_eq!(found, values);
    }

    #[test]
    fn few_rows_and_neighbours_are_no_blocks() {
        assert!(Copies::of(&matrix()[..35], 5).is_none());
        let neighbours: Vec<_> = (0..40).map(Value::Work).collect();
        assert!(Copies::of(&neighbours, 5).is_none());
    }
}
