//! The rank of a matrix in 256 bits, by elimination of columns.
//!
//! In: a matrix without units at several states, by its columns, and the order of its rows at each. Out: how many columns do
//! not depend on each other, or that 256 bits do not tell. Columns come last first, and a pivot is in the first row of the
//! order where much of a column is left: what hangs further out is seen by rows of its own, and most products are zero.
//! A column of which little is left waits until those of which more is left have been taken: dividing by little, early,
//! would cost the digits that tell later columns apart.

use crate::big::Big;

/// How many columns do not depend on each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rank {
    /// So many; and so many of those by a part of themselves that 106 bits tell.
    Of { all: usize, visible: usize },
    /// 256 bits do not tell.
    Unknown,
}

/// What is left of a column that depends on others is less, and of one that does not more.
const DEPENDENT: f64 = 1e-58;
const INDEPENDENT: f64 = 1e-50;

/// What is left of a column is less where 106 bits do not tell it from nothing: the square of a residue of `f64` is.
const VISIBLE: f64 = 1e-20;

/// So much of the largest entry that is left is enough of a pivot.
const MUCH: f64 = 1e-3;

/// A column by rows, each with its entries at all states; none where all are zero.
type Column = Vec<Option<Vec<Big>>>;

struct Pivot {
    row: usize,
    state: usize,
    column: Column,
}

/// So much has to be left of a column that is taken, in one pass after the other.
const FLOORS: [f64; 5] = [1e-3, 1e-6, 1e-12, 1e-24, INDEPENDENT];

/// A column that has not been taken, less what the first so many pivots take off.
struct Waiting {
    column: Column,
    reduced: usize,
}

pub(super) fn rank(states: &[Vec<Vec<Big>>], order: &[usize]) -> Rank {
    let Some(first) = states.first() else {
        return Rank::Of { all: 0, visible: 0 };
    };
    let columns = (0..first.len()).rev();
    let columns = columns.map(|k| Waiting {
        column: column(states, k),
        reduced: 0,
    });
    let mut waiting: Vec<Waiting> = columns.collect();
    let mut pivots: Vec<Pivot> = Vec::new();
    let mut visible = 0;
    for floor in FLOORS {
        let mut later = Vec::new();
        for mut next in waiting {
            for pivot in &pivots[next.reduced..] {
                reduce(&mut next.column, pivot);
            }
            next.reduced = pivots.len();
            let sizes = sizes(&next.column);
            let left = most(&sizes);
            if left < floor {
                later.push(next);
                continue;
            }
            visible += usize::from(left >= VISIBLE);
            let mut rows = order.iter().copied();
            let row = rows
                .find(|&row| sizes[row] >= MUCH * left)
                .expect("one is the largest");
            pivots.push(pivot(next.column, row));
        }
        waiting = later;
    }
    // Those that were passed before the last pivot was found are less it, or little.
    let left = waiting.iter_mut().map(|next| {
        for pivot in &pivots[next.reduced..] {
            reduce(&mut next.column, pivot);
        }
        most(&sizes(&next.column))
    });
    if left.fold(0.0, f64::max) < DEPENDENT {
        Rank::Of {
            all: pivots.len(),
            visible,
        }
    } else {
        Rank::Unknown
    }
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

/// A column with 1 at the largest entry of a row.
fn pivot(mut column: Column, row: usize) -> Pivot {
    let entries = column[row].as_ref().expect("much is left");
    let size = |state: &usize| entries[*state].abs().to_f64();
    let largest = (0..entries.len()).max_by(|a, b| size(a).total_cmp(&size(b)));
    let state = largest.expect("there are states");
    let value = entries[state].clone();
    for entry in column.iter_mut().flatten().flatten() {
        *entry = &*entry / &value;
    }
    Pivot { row, state, column }
}

/// Makes an entry of a column zero.
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
