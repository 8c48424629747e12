//! Rank of a matrix in 256 bits, by elimination of columns.
//!
//! In: a matrix without units at several states, by columns, and the order of its rows at each state. Out: the number
//! of independent columns, or that it is undecided in 256 bits.
//!
//! Columns are eliminated from the last to the first. The pivot is in the first row of the order with a large entry:
//! outer bodies have rows of their own, so most products are zero. A column with small entries left waits until those
//! with larger entries are done: early division by small entries would lose the digits that separate later columns.

use crate::big::Big;

/// Upper bound of the remainder of a dependent column, and lower bound of that of an independent one. Rounding in 256
/// bits leaves up to 1e-50 of a dependent column in long chains, where 320 bits leave less than 1e-58; the square of a
/// residue of `f64` is above 1e-36.
const DEPENDENT: f64 = 1e-46;
const INDEPENDENT: f64 = 1e-38;

/// Lower bound of a pivot, relative to the largest entry of its column.
const MUCH: f64 = 1e-3;

/// A column by rows, each with its entries at all states; `None` if all are zero.
type Column = Vec<Option<Vec<Big>>>;

struct Pivot {
    row: usize,
    state: usize,
    column: Column,
}

/// Lower bounds of remainders, one for each pass.
const FLOORS: [f64; 5] = [1e-3, 1e-6, 1e-12, 1e-24, INDEPENDENT];

/// A column without a pivot, reduced by the first `reduced` pivots.
struct Waiting {
    column: Column,
    reduced: usize,
}

/// The number of independent columns; `None` if 256 bits do not decide it.
pub(super) fn rank(states: &[Vec<Vec<Big>>], order: &[usize]) -> Option<usize> {
    let Some(first) = states.first() else {
        return Some(0);
    };
    let columns = (0..first.len()).rev();
    let columns = columns.map(|k| Waiting {
        column: column(states, k),
        reduced: 0,
    });
    let mut waiting: Vec<Waiting> = columns.collect();
    let mut pivots: Vec<Pivot> = Vec::new();
    for floor in FLOORS {
        let mut later = Vec::new();
        for mut next in waiting {
            for pivot in &pivots[next.reduced..] {
                reduce(&mut next.column, pivot);
            }
            next.reduced = pivots.len();
            let sizes = sizes(&next.column);
            let remainder = most(&sizes);
            if remainder < floor {
                later.push(next);
                continue;
            }
            let mut rows = order.iter().copied();
            let row = rows
                .find(|&row| sizes[row] >= MUCH * remainder)
                .expect("one is the largest");
            pivots.push(pivot(next.column, row));
        }
        waiting = later;
    }
    // Reduce the remaining columns by the last pivots too.
    let remainders = waiting.iter_mut().map(|next| {
        for pivot in &pivots[next.reduced..] {
            reduce(&mut next.column, pivot);
        }
        most(&sizes(&next.column))
    });
    (remainders.fold(0.0, f64::max) < DEPENDENT).then_some(pivots.len())
}

fn column(states: &[Vec<Vec<Big>>], k: usize) -> Column {
    let rows = 0..states[0][k].len();
    let column = rows.map(|row| {
        let entries = states.iter().map(|columns| columns[k][row].clone());
        let entries: Vec<Big> = entries.collect();
        let is_zero = entries.iter().all(|entry| *entry == Big::zero());
        (!is_zero).then_some(entries)
    });
    column.collect()
}

/// The largest entry of each row.
fn sizes(column: &Column) -> Vec<f64> {
    let largest = |entries: &Option<Vec<Big>>| {
        let sizes = entries.iter().flatten().map(|entry| entry.abs().to_f64());
        sizes.fold(0.0, f64::max)
    };
    column.iter().map(largest).collect()
}

fn most(sizes: &[f64]) -> f64 {
    sizes.iter().copied().fold(0.0, f64::max)
}

/// Scales a column to 1 at the largest entry of a row.
fn pivot(mut column: Column, row: usize) -> Pivot {
    let entries = column[row].as_ref().expect("the row has entries");
    let size = |state: &usize| entries[*state].abs().to_f64();
    let largest = (0..entries.len()).max_by(|a, b| size(a).total_cmp(&size(b)));
    let state = largest.expect("there are states");
    let value = entries[state].clone();
    for entry in column.iter_mut().flatten().flatten() {
        *entry = &*entry / &value;
    }
    Pivot { row, state, column }
}

/// Subtracts a multiple of the pivot's column, so that the entry at the pivot is zero.
fn reduce(column: &mut Column, pivot: &Pivot) {
    let Some(entries) = &column[pivot.row] else {
        return;
    };
    let factor = entries[pivot.state].clone();
    if factor == Big::zero() {
        return;
    }
    for (rest, of_pivot) in column.iter_mut().zip(&pivot.column) {
        let Some(of_pivot) = of_pivot else { continue };
        let rest = rest.get_or_insert_with(|| vec![Big::zero(); of_pivot.len()]);
        for (rest, entry) in rest.iter_mut().zip(of_pivot) {
            *rest = &*rest - &(&factor * entry);
        }
    }
    if let Some(entries) = &mut column[pivot.row] {
        entries[pivot.state] = Big::zero();
    }
}
