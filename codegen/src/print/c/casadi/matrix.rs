//! Matrices of `CasADi` over the arrays of C functions.
//!
//! In: a quantity and the operands of its results. Out: sizes, and the place in the array of each entry that is not a
//! structural zero, column by column.

use crate::print::arrays::has_columns;
use crate::print::c::declarations::lengths;
use crate::schedule::Operand;
use crate::space::{Quantity, Spaces};

/// Source of an entry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum EntrySource {
    /// A place in the array.
    Place(usize),
    /// The number 1.
    One,
}

/// A sparse matrix. Several matrices of a result stand beside each other, row by row; several poses one below the other.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SparseMatrix {
    pub rows: usize,
    pub columns: usize,
    /// Row, column and source of each entry, column by column.
    pub entries: Vec<(usize, usize, EntrySource)>,
    /// Distances in the array from one row to the next, and from one column to the next.
    pub strides: [usize; 2],
}

impl SparseMatrix {
    /// Matrix of a result.
    pub fn of(quantity: &Quantity, spaces: &Spaces, operands: &[Operand]) -> Self {
        if let Some(last) = quantity.entity.fourth_row() {
            return Self::of_four_rows(last, operands);
        }
        let lengths = lengths(quantity, spaces);
        let (rows, columns) = match *lengths {
            [] => (1, 1),
            [rows] => (rows, 1),
            [rows, ref columns @ ..] => (rows, columns.iter().product()),
        };
        let is_transposed = quantity.over.len() == 1 && has_columns(quantity);
        let mut entries = Vec::new();
        for (place, operand) in operands.iter().enumerate() {
            // A function that could not be expanded has no operands, and a zero is no entry.
            if *operand == Operand::Literal(0.0) {
                continue;
            }
            let (row, column) = (place / columns, place % columns);
            let at = if is_transposed {
                (column, row)
            } else {
                (row, column)
            };
            entries.push((at.0, at.1, EntrySource::Place(place)));
        }
        let (shape, strides) = if is_transposed {
            ([columns, rows], [1, columns])
        } else {
            ([rows, columns], [columns, 1])
        };
        Self::sorted(shape, entries, strides)
    }

    /// Matrices of which the array has three rows.
    fn of_four_rows(last: [f64; 4], operands: &[Operand]) -> Self {
        let mut entries = Vec::new();
        let matrices = operands.chunks(12).enumerate();
        for (matrix, operands) in matrices.clone() {
            for (place, operand) in operands.iter().enumerate() {
                if *operand != Operand::Literal(0.0) {
                    let place_of_all = EntrySource::Place(12 * matrix + place);
                    entries.push((4 * matrix + place / 4, place % 4, place_of_all));
                }
            }
            let ones = last.iter().enumerate().filter(|(_, entry)| **entry != 0.0);
            entries.extend(ones.map(|(column, _)| (4 * matrix + 3, column, EntrySource::One)));
        }
        Self::sorted([4 * matrices.len(), 4], entries, [4, 1])
    }

    fn sorted(
        [rows, columns]: [usize; 2],
        mut entries: Vec<(usize, usize, EntrySource)>,
        strides: [usize; 2],
    ) -> Self {
        entries.sort_by_key(|&(row, column, _)| (column, row));
        Self {
            rows,
            columns,
            entries,
            strides,
        }
    }

    /// Matrix without zeros whose entries are those of an array, column by column.
    pub fn full(rows: usize, columns: usize) -> Self {
        let entries = (0..rows * columns).map(|k| (k % rows, k / rows, EntrySource::Place(k)));
        Self {
            rows,
            columns,
            entries: entries.collect(),
            strides: [1, rows],
        }
    }

    /// Matrix of zeros.
    pub fn zero(rows: usize, columns: usize) -> Self {
        Self::sorted([rows, columns], Vec::new(), [0; 2])
    }

    pub fn transposed(&self) -> Self {
        let entries = self.entries.iter();
        let entries = entries.map(|&(row, column, source)| (column, row, source));
        let [down, right] = self.strides;
        Self::sorted([self.columns, self.rows], entries.collect(), [right, down])
    }

    /// The matrix without the rows that `keep` rejects.
    pub fn rows_where(mut self, keep: impl Fn(usize) -> bool) -> Self {
        self.entries.retain(|(row, ..)| keep(*row));
        self
    }

    /// Number of entries, zeros included.
    pub const fn size(&self) -> usize {
        self.rows * self.columns
    }

    /// True if no entry is a structural zero.
    pub fn is_full(&self) -> bool {
        self.entries.len() == self.size()
    }

    /// Sparsity pattern in `CasADi`'s form: rows, columns, and 1, or where each column begins and the row of each entry.
    pub fn pattern(&self) -> Vec<String> {
        let mut numbers = vec![self.rows, self.columns];
        if self.is_full() && self.size() > 0 {
            numbers.push(1);
        } else {
            let before = |column| self.entries.iter().filter(move |entry| entry.1 < column);
            numbers.extend((0..=self.columns).map(|column| before(column).count()));
            numbers.extend(self.entries.iter().map(|(row, ..)| row));
        }
        numbers.iter().map(ToString::to_string).collect()
    }

    /// Places in the array of the entries; -1 for the number 1.
    pub fn places(&self) -> Vec<String> {
        let places = self.entries.iter().map(|(.., source)| match source {
            EntrySource::Place(place) => place.to_string(),
            EntrySource::One => "-1".to_owned(),
        });
        places.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{EntrySource, SparseMatrix};
    use crate::function::Function;
    use crate::schedule::Operand;
    use crate::space::Spaces;

    #[test]
    fn a_pose_has_its_last_row_and_no_zeros() {
        let (_, pose) = Function::ForwardKinematics.result().parts().next().unwrap();
        let operands = [[0.0, 2.0, 2.0, 2.0]; 3].concat();
        let operands: Vec<Operand> = operands.into_iter().map(Operand::Literal).collect();
        let matrix = SparseMatrix::of(&pose, &Spaces::default(), &operands);
        assert_eq!((matrix.rows, matrix.columns), (4, 4));
        let pattern = "4 4 0 0 3 6 10 0 1 2 0 1 2 0 1 2 3";
        assert_eq!(matrix.pattern().join(" "), pattern);
        assert_eq!(matrix.places().join(" "), "1 5 9 2 6 10 3 7 11 -1");
    }

    #[test]
    fn several_poses_stand_one_below_the_other() {
        let (_, poses) = Function::FramePoses.result().parts().next().unwrap();
        let operands = [Operand::Literal(2.0); 24];
        let matrix = SparseMatrix::of(&poses, &Spaces::default(), &operands);
        assert_eq!((matrix.rows, matrix.columns), (8, 4));
        let column = |wanted: usize| {
            let of = matrix.entries.iter().filter(move |entry| entry.1 == wanted);
            of.map(|&(row, _, source)| (row, source))
                .collect::<Vec<_>>()
        };
        let translations = [(0, 3), (1, 7), (2, 11), (4, 15), (5, 19), (6, 23)];
        let mut last = translations
            .map(|(row, place)| (row, EntrySource::Place(place)))
            .to_vec();
        last.extend([(3, EntrySource::One), (7, EntrySource::One)]);
        last.sort_by_key(|(row, _)| *row);
        assert_eq!(column(3), last);
        assert_eq!(column(0).len(), 6);
    }

    #[test]
    fn full_matrices_have_the_short_pattern() {
        let full = SparseMatrix::full(2, 3);
        assert_eq!(full.pattern(), ["2", "3", "1"]);
        assert_eq!(full.transposed().places().join(" "), "0 2 4 1 3 5");
        assert_eq!(SparseMatrix::zero(2, 1).pattern().join(" "), "2 1 0 0");
        let lower = full.rows_where(|row| row == 1);
        assert_eq!(lower.entries[0], (1, 0, EntrySource::Place(1)));
        assert_eq!(lower.pattern().join(" "), "2 3 0 1 2 3 1 1 1");
    }
}
