//! Groups of the columns of y = C x, each of which multiplies one vector.
//!
//! In: columns. Out: groups whose values are entries of one vector, according to labels and factors, and groups that
//! are A R v or A Rᵗ v, with the rotation matrix R of a quaternion and a constant matrix A.

use super::combination::{Column, ROWS};
use super::kind::{ColumnKind, Monomial};
use super::known::Known;
use super::norm::root;
use crate::schedule::Operand;

/// Columns that multiply the entries of one vector.
#[derive(Clone)]
pub struct ColumnGroup {
    pub kind: ColumnKind,
    pub members: Vec<Monomial>,
    pub matrix: Vec<[f64; ROWS]>,
}

impl ColumnGroup {
    pub fn take(&mut self, member: Monomial, entries: [f64; ROWS]) {
        self.members.push(member);
        self.matrix.push(entries);
    }
}

/// Adds columns to the groups of their kinds.
pub fn by_kind(known: &Known<'_>, columns: &[Column], groups: &mut Vec<ColumnGroup>) {
    for column in columns {
        let kind = known.kind_of(column.of);
        let found = groups.iter_mut().find(|group| group.kind == kind);
        match found {
            Some(group) => group.take(column.of, column.entries),
            None => groups.push(ColumnGroup {
                kind,
                members: vec![column.of],
                matrix: vec![column.entries],
            }),
        }
    }
}

/// Column that multiplies a product with an entry of R, rᵢₖ vₖ.
struct RotatedColumn {
    /// Index among the columns.
    at: usize,
    /// Row and column of the entry of R.
    place: [usize; 2],
    /// Error of the entry.
    error: f64,
    /// vₖ; 1 if all other factors are literals.
    by: Operand,
    entries: [f64; ROWS],
}

/// Removes the columns of rotated vectors: for each vector v a group, whose matrix is A.
pub fn rotated(known: &Known<'_>, columns: &mut Vec<Column>) -> Vec<ColumnGroup> {
    let mut found = Vec::new();
    let mut first = 0;
    while first < columns.len() {
        let Some((group, taken)) = with_first(known, columns, first) else {
            first += 1;
            continue;
        };
        found.push(group);
        let mut at = 0..;
        columns.retain(|_| at.next().is_some_and(|at| !taken.contains(&at)));
    }
    found
}

/// Group of this column and later ones, with their indices: all have entries of the same R, and their other factors are
/// entries of the same vector according to labels.
fn with_first(
    known: &Known<'_>,
    columns: &[Column],
    first: usize,
) -> Option<(ColumnGroup, Vec<usize>)> {
    let one = Operand::Literal(1.0);
    let part = |at: usize, quaternion: Option<_>, kind: Option<ColumnKind>| {
        let Column { of, entries } = columns[at];
        let factors = match of {
            Monomial::Whole(a) => [(a, one); 2],
            Monomial::Product(a, b) => [(a, b), (b, a)],
        };
        // The first suitable factor, so that a column counts once if both factors are entries of matrices.
        factors.into_iter().find_map(|(a, by)| {
            let entry = known.entry(a)?;
            let is_same = quaternion.is_none_or(|quaternion| quaternion == entry.quaternion);
            let is_alike = kind.is_none_or(|kind| kind == known.kind_of(Monomial::Whole(by)));
            (is_same && is_alike).then(|| {
                let part = RotatedColumn {
                    at,
                    place: entry.place,
                    error: known.value(a).error,
                    by,
                    entries: entries.map(|x| entry.sign * x),
                };
                (entry.quaternion, part)
            })
        })
    };
    let (quaternion, RotatedColumn { by, .. }) = part(first, None, None)?;
    let kinds = [None, Some(known.kind_of(Monomial::Whole(by)))];
    kinds.into_iter().find_map(|kind| {
        let later = (first..columns.len()).filter_map(|at| part(at, Some(quaternion), kind));
        let parts: Vec<RotatedColumn> = later.map(|(_, part)| part).collect();
        let group = (0..2).find_map(|axis| together(&parts, axis))?;
        Some((group, parts.iter().map(|part| part.at).collect()))
    })
}

/// Group of columns that are A R v (`axis` 1) or A Rᵗ v (`axis` 0). It exists if the columns of each vₖ are λₖ A: then
/// y = A R (λ v), and λ v is no longer than v, since λ ≤ 1.
fn together(parts: &[RotatedColumn], axis: usize) -> Option<ColumnGroup> {
    /// Larger than the rounding errors of equal numbers.
    const NEARLY: f64 = 1e-13;
    // Matrix that multiplies each entry of v: λₖ A.
    let mut blocks = [[[0.0; ROWS]; 3]; 3];
    let mut given = [[false; 3]; 3];
    let mut values = [None; 3];
    for part in parts {
        let [i, k] = [part.place[1 - axis], part.place[axis]];
        if given[k][i] || values[k].is_some_and(|by| by != part.by) {
            return None;
        }
        (given[k][i], values[k], blocks[k][i]) = (true, Some(part.by), part.entries);
    }
    let size = |block: &[[f64; ROWS]; 3]| root(block.iter().flatten().copied());
    let matrix = (blocks.into_iter()).max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let unit = size(&matrix);
    let mut members = Vec::new();
    for (block, value) in blocks.iter().zip(values) {
        let pairs = || block.iter().flatten().zip(matrix.iter().flatten());
        let factor = pairs().map(|(x, a)| (x / unit) * (a / unit)).sum::<f64>();
        if !pairs().all(|(x, a)| (x - factor * a).abs() <= NEARLY * unit) {
            return None;
        }
        // A is the largest block, so that no factor exceeds 1.
        members.extend(value.map(|by| match by {
            Operand::Literal(_) => Monomial::Whole(Operand::Literal(factor)),
            value => Monomial::Whole(value),
        }));
    }
    (parts.len() > 1).then(|| ColumnGroup {
        kind: ColumnKind::Rotated(root(parts.iter().map(|part| part.error))),
        members,
        matrix: matrix.to_vec(),
    })
}
