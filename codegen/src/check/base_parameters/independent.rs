//! Linear independence of columns of the regressor, by elimination of rows.
//!
//! In: the blocks in which base parameters were found, and rows of regressors. Out: the first column that depends on
//! others. Rows of a block's velocities are zero in columns of blocks further inwards, which is checked first: so the
//! columns are independent if those of each block are in its own rows.

use std::collections::BTreeSet;

use super::balance::units;
use crate::chain::base_parameters::{BaseParameters, LinkBlock};
use crate::dense::{Approximate, Columns};
use crate::expression::Double;
use crate::list::List;
use crate::space::{ParameterId, VelocityId};

/// Ratio of an entry to the size of its terms below which it is a rounding error of 106 bits.
pub(super) const ROUNDED: f64 = 1e-24;

/// The regressor at a state: Y, and the sizes of the terms of its entries; and torques of the motion.
pub(super) struct Seen {
    pub(super) torques: List<VelocityId, Approximate>,
    pub(super) regressor: Columns<Approximate>,
    pub(super) sizes: Columns<f64>,
}

/// A base parameter that depends on others.
pub(super) struct Dependent(pub(super) ParameterId);

/// The rows of a block's velocities in the columns of its leaders, at some states.
pub(super) type Rows = Vec<Vec<SizedEntry>>;

/// An entry, and the size of its terms.
type SizedEntry = (Double, f64);

/// The rows at one state.
pub(super) fn own_rows(block: &LinkBlock, at: &Seen) -> impl Iterator<Item = Vec<SizedEntry>> {
    block.velocities.iter().map(|&row| {
        let leading = block.leading.iter();
        let entry = |&of: &ParameterId| (at.regressor[of][row].value, at.sizes[of][row]);
        leading.map(entry).collect()
    })
}

/// The first column that depends on others.
pub(super) fn first_dependent(
    base: &BaseParameters,
    at: &Seen,
    rows: Vec<Rows>,
) -> Option<Dependent> {
    let leading = base.blocks.iter().flat_map(|block| &block.leading);
    let leading: BTreeSet<ParameterId> = leading.copied().collect();
    if let Some(unknown) = base.columns().find(|column| !leading.contains(column)) {
        return Some(Dependent(unknown));
    }
    // The leading parameters of the blocks further inwards.
    let mut inner: Vec<ParameterId> = Vec::new();
    for block in base.blocks.iter().rev() {
        let sees = |&parameter: &ParameterId| {
            let mut rows = block.velocities.iter();
            rows.any(|&row| at.sizes[parameter][row] > 0.0)
        };
        if let Some(seen) = inner.iter().copied().find(sees) {
            return Some(Dependent(seen));
        }
        inner.extend(&block.leading);
    }
    let mut blocks = base.blocks.iter().zip(rows);
    blocks.find_map(|(block, rows)| Some(Dependent(block.leading[dependent(rows)?])))
}

/// The first column without a pivot in some rows, by complete pivoting. A residual is a pivot if it is larger than the
/// rounding of its terms.
fn dependent(mut rows: Rows) -> Option<usize> {
    balance(&mut rows);
    let mut columns: Vec<usize> = (0..rows.first().map_or(0, Vec::len)).collect();
    while let Some(&first) = columns.first() {
        let places =
            (0..rows.len()).flat_map(|row| columns.iter().map(move |&column| (row, column)));
        let left = |&(row, column): &(usize, usize)| {
            let (entry, size): SizedEntry = rows[row][column];
            let entry = entry.to_f64().abs();
            if entry > ROUNDED * size { entry } else { 0.0 }
        };
        let best = places.max_by(|a, b| left(a).total_cmp(&left(b)));
        let Some((row, column)) = best.filter(|place| left(place) > 0.0) else {
            return Some(first);
        };
        let pivot = rows.swap_remove(row);
        columns.retain(|other| *other != column);
        let inverse = Double::from(1.0) / pivot[column].0;
        for row in &mut rows {
            let factor = row[column].0 * inverse;
            reduce(row, &pivot, factor, &columns);
        }
    }
    None
}

/// Divides rows and columns by units of their own. Otherwise a pivot that is large relative to its terms may be small
/// in its row, and rounding errors grow.
fn balance(rows: &mut Rows) {
    let sizes = rows.iter().map(|row| row.iter().map(|(_, size)| *size));
    let [of_rows, of_columns] = units(sizes.map(Iterator::collect).collect());
    for (row, of_row) in rows.iter_mut().zip(&of_rows) {
        for ((entry, size), of_column) in row.iter_mut().zip(&of_columns) {
            let unit = 1.0 / (of_row * of_column);
            (*entry, *size) = (*entry * Double::from(unit), *size * unit);
        }
    }
}

/// Subtracts a multiple of a row from another one, in some columns.
fn reduce(row: &mut [SizedEntry], pivot: &[SizedEntry], factor: Double, columns: &[usize]) {
    let scale = factor.to_f64();
    if scale == 0.0 {
        return;
    }
    for &column in columns {
        let (entry, size) = row[column];
        let (term, of_term) = pivot[column];
        let of_term = scale * of_term;
        row[column] = (
            entry - factor * term,
            (size * size + of_term * of_term).sqrt(),
        );
    }
}
