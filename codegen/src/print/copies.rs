//! Matrices of results that loops copy.
//!
//! In: the values of a matrix, by rows. Out: loops over rows, for columns whose values stand at equal distances in the
//! work array, and for those that have the same literal in these rows; and all other entries. Loops over columns of a
//! program store such values, and limbs that do not act on each other have blocks of zeros. What a symmetric matrix has
//! above its diagonal is copied from below it.
//!
//! Compilers compare all copies of a function with each other, and thousands take them seconds.

use std::ops::Range;

use crate::schedule::Value;

/// Minimum number of rows of a loop.
const ROWS: usize = 4;

/// A matrix in loops.
pub(super) struct Copies {
    /// Loops.
    pub loops: Vec<CopyLoop>,
    /// Indices of all entries that are in no loop, in ascending order.
    pub rest: Vec<usize>,
    /// True if the entries above the diagonal are none of these, and equal those below it.
    pub is_symmetric: bool,
}

/// Loop over consecutive rows.
pub(super) struct CopyLoop {
    /// The rows.
    pub rows: Range<usize>,
    /// Columns that are copied.
    pub blocks: Vec<CopiedBlock>,
    /// Columns that have the same literal in all of the rows.
    pub constant: Vec<(usize, f64)>,
}

/// Columns whose values stand at equal distances in the work array, in all rows of a loop.
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

/// Values of consecutive rows of a column.
#[derive(Clone, Copy)]
enum InAColumn {
    /// The same literal.
    Literal(f64),
    /// Values in the work array: the index of the first, and the distance of neighbours.
    Work(usize, usize),
}

impl Copies {
    /// Loops of a matrix with these numbers of rows and columns; no value is known of an entry that is stored already.
    pub fn of<'v>([rows, columns]: [usize; 2], value: impl Fn(usize) -> Option<&'v Value>) -> Self {
        let entry = |row: usize, column: usize| value(row * columns + column);
        let is_symmetric = rows == columns
            && (0..rows).all(|row| {
                let mut pairs = (0..=row).map(|k| [entry(row, k), entry(k, row)]);
                pairs.all(|[below, above]| below.is_some() && below == above)
            });
        let mut copies = Self {
            loops: Vec::new(),
            rest: Vec::new(),
            is_symmetric,
        };
        for column in 0..columns {
            let index = |row: usize| row * columns + column;
            let entry = |row: usize| entry(row, column);
            let mut row = if is_symmetric { column } else { 0 };
            while row < rows {
                if let Some((values, count)) = InAColumn::of((row..rows).map_while(entry)) {
                    copies.take(row..row + count, column, values);
                    row += count;
                } else {
                    copies.rest.extend(entry(row).map(|_| index(row)));
                    row += 1;
                }
            }
        }
        copies.rest.sort_unstable();
        copies
    }

    /// Adds a column to the loop over these rows.
    fn take(&mut self, rows: Range<usize>, column: usize, values: InAColumn) {
        let known = self.loops.iter().position(|known| known.rows == rows);
        let place = known.unwrap_or_else(|| {
            self.loops.push(CopyLoop {
                rows,
                blocks: Vec::new(),
                constant: Vec::new(),
            });
            self.loops.len() - 1
        });
        let of_rows = &mut self.loops[place];
        match values {
            InAColumn::Literal(value) => of_rows.constant.push((column, value)),
            InAColumn::Work(first, down) => of_rows.block(column, first, down),
        }
    }
}

impl CopyLoop {
    /// Adds a column of copied values, to the last block if it continues that.
    fn block(&mut self, column: usize, first: usize, down: usize) {
        if let Some(last) = self.blocks.last_mut()
            && last.column + last.count == column
            && last.down == down
            && let Some(distance) = first.checked_sub(last.first)
        {
            // Neighbours in both arrays are no block: compilers would call `memcpy`, which firmware may lack.
            if last.count == 1 && distance > 1 {
                last.along = distance;
            }
            if last.along > 0 && distance == last.count * last.along {
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

impl InAColumn {
    /// The longest stretch from the first value on, with the number of its rows, if a loop is shorter.
    fn of<'v>(values: impl Iterator<Item = &'v Value> + Clone) -> Option<(Self, usize)> {
        let place = |value: &Value| match value {
            Value::Work(place) => Some(*place),
            _ => None,
        };
        let (found, count) = match values.clone().next()? {
            literal @ Value::Literal(value) => {
                let count = values.take_while(|of| *of == literal).count();
                (Self::Literal(*value), count)
            }
            Value::Work(_) => {
                let ([first, down], count) = at_equal_distances(values.map_while(place))?;
                (Self::Work(first, down), count)
            }
            _ => return None,
        };
        (count >= ROWS).then_some((found, count))
    }
}

/// The first of some places and the distance of neighbours, at least 1, with the number of places up to the first that
/// is elsewhere.
pub(super) fn at_equal_distances(
    places: impl Iterator<Item = usize> + Clone,
) -> Option<([usize; 2], usize)> {
    let mut two = places.clone();
    let first = two.next()?;
    let distance = two.next()?.checked_sub(first).filter(|&apart| apart > 0)?;
    let expected = (0..).map(|k| first + k * distance);
    let pairs = places.zip(expected);
    let count = pairs.take_while(|(found, expected)| found == expected);
    Some(([first, distance], count.count()))
}

#[cfg(test)]
mod tests {
    use super::Copies;
    use crate::schedule::Value;

    const COLUMNS: usize = 6;

    /// 8 rows: zeros in the upper half, an entry each of two blocks, neighbours of the second, and values that are apart
    /// in one row.
    fn matrix() -> Vec<Value> {
        let row = |row: usize| {
            let upper = if row < 4 {
                Value::Literal(0.0)
            } else {
                Value::Name(format!("t_{row}"))
            };
            let apart = if row == 3 { 999 } else { 300 + row };
            let [a, b, c, d] = [100 + row, 120 + row, 200 + 2 * row, 201 + 2 * row];
            let [a, b, c, d, apart] = [a, b, c, d, apart].map(Value::Work);
            [upper, a, b, c, d, apart]
        };
        (0..8).flat_map(row).collect()
    }

    #[test]
    fn blocks_have_equal_distances_in_consecutive_rows() {
        let values = matrix();
        let copies = Copies::of([8, COLUMNS], |index| Some(&values[index]));
        let loops = copies.loops.iter().map(|each| {
            let blocks = each.blocks.iter();
            let blocks = blocks.map(|it| [it.column, it.count, it.first, it.down, it.along]);
            (each.rows.clone(), each.constant.clone(), blocks.collect())
        });
        let loops: Vec<(_, _, Vec<_>)> = loops.collect();
        let all = vec![[1, 2, 100, 1, 20], [3, 1, 200, 2, 0], [4, 1, 201, 2, 0]];
        let expected = [
            (0..4, vec![(0, 0.0)], Vec::new()),
            (0..8, Vec::new(), all),
            (4..8, Vec::new(), vec![[5, 1, 304, 1, 0]]),
        ];
        assert_eq!(loops, expected);
        let rest = [5, 11, 17, 23, 24, 30, 36, 42];
        assert_eq!(copies.rest, rest);
    }

    #[test]
    fn a_symmetric_matrix_is_copied_below_its_diagonal() {
        let symmetric = |index: usize| {
            let [row, column] = [index / COLUMNS, index % COLUMNS];
            Value::Work(10 * row.max(column) + row.min(column))
        };
        let mut values: Vec<Value> = (0..COLUMNS * COLUMNS).map(symmetric).collect();
        let of = |values: &[Value]| Copies::of([COLUMNS; 2], |index| Some(&values[index]));
        let copies = of(&values);
        assert!(copies.is_symmetric);
        let rows = copies.loops.iter().map(|each| each.rows.clone());
        assert_eq!(rows.collect::<Vec<_>>(), [0..6, 1..6, 2..6]);
        assert_eq!(copies.rest, [21, 27, 28, 33, 34, 35]);

        values[3] = Value::Work(0);
        assert!(!of(&values).is_symmetric);
        let stored = Copies::of([COLUMNS; 2], |index| (index != 7).then(|| &values[index]));
        assert!(!stored.is_symmetric);
    }

    #[test]
    fn every_entry_is_copied_once_unless_it_is_stored() {
        let values = matrix();
        for stored in [None, Some(13), Some(24)] {
            let copies = Copies::of([8, COLUMNS], |index| {
                (Some(index) != stored).then(|| &values[index])
            });
            let mut found = vec![None; values.len()];
            let mut set = |row: usize, column: usize, value: Value| {
                assert_eq!(found[COLUMNS * row + column].replace(value), None);
            };
            for each in &copies.loops {
                for (row, of) in each.rows.clone().enumerate() {
                    for block in &each.blocks {
                        for k in 0..block.count {
                            let place = block.first + block.down * row + block.along * k;
                            set(of, block.column + k, Value::Work(place));
                        }
                    }
                    for &(column, value) in &each.constant {
                        set(of, column, Value::Literal(value));
                    }
                }
            }
            for index in copies.rest {
                set(index / COLUMNS, index % COLUMNS, values[index].clone());
            }
            for (index, value) in found.into_iter().enumerate() {
                let expected = (Some(index) != stored).then(|| values[index].clone());
                assert_eq!(value, expected);
            }
        }
    }
}
