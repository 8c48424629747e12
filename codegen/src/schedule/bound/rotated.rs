//! Vectors that the rotation matrix R of a quaternion carries, within y = C x.
//!
//! In: columns of C, some of which multiply products with entries of R, or such entries themselves. Out: the columns
//! that together are A R v or A Rᵗ v, with a matrix A of numbers, and those left. It never looks at how long v is.

use super::combination::{Column, ROWS};
use super::kind::Of;
use super::known::Known;
use super::norm::root;
use super::quaternion::Entry;
use crate::schedule::Operand;

/// A column that an entry of R multiplies.
struct Part {
    /// Its place among the columns.
    at: usize,
    entry: Entry,
    /// The error of that entry.
    error: f64,
    /// The entry of v; none where that is a number.
    by: Option<Operand>,
    /// The column, by the entry of R without a sign.
    entries: [f64; ROWS],
}

/// Columns that are A R v, with vₖ = λₖ xₖ and numbers |λₖ| ≤ 1, or vₖ = λₖ.
pub struct Rotated {
    /// The xₖ; none where v is made of numbers.
    pub values: Vec<Operand>,
    /// √(λ₀² + …).
    pub numbers: f64,
    /// A, by its columns.
    pub matrix: Vec<[f64; ROWS]>,
    /// √(δ² + …) of the errors of the entries of R.
    pub error: f64,
}

/// Takes them out of the columns.
pub fn take(known: &Known<'_>, columns: &mut Vec<Column>) -> Vec<Rotated> {
    let mut found = Vec::new();
    let mut first = 0;
    while first < columns.len() {
        let Some((rotated, taken)) = from(known, columns, first) else {
            first += 1;
            continue;
        };
        found.push(rotated);
        let mut at = 0..;
        columns.retain(|_| at.next().is_some_and(|at| !taken.contains(&at)));
    }
    found
}

/// The first that has this column and later ones, and their places: all that multiply entries of the same R, or those
/// among them whose other factors are entries of one vector as far as labels tell.
fn from(known: &Known<'_>, columns: &[Column], first: usize) -> Option<(Rotated, Vec<usize>)> {
    let kind = |part: &Part| part.by.map(|by| known.kind_of(Of::Whole(by)));
    parts(known, columns, first).find_map(|seed| {
        let belongs = |part: &Part| {
            part.entry.quaternion == seed.entry.quaternion && part.by.is_some() == seed.by.is_some()
        };
        // Each column once, whose factors may both be entries of R.
        let all = (first..columns.len()).filter_map(|at| parts(known, columns, at).find(belongs));
        let all: Vec<Part> = all.collect();
        let alike = all.iter().filter(|part| kind(part) == kind(&seed));
        let choices: [Vec<&Part>; 2] = [all.iter().collect(), alike.collect()];
        choices.into_iter().find_map(|parts| {
            let rotated = (0..2).find_map(|axis| together(&parts, axis))?;
            Some((rotated, parts.iter().map(|part| part.at).collect()))
        })
    })
}

/// A column by each of its factors that is an entry of a rotation matrix.
fn parts(known: &Known<'_>, columns: &[Column], at: usize) -> impl Iterator<Item = Part> {
    let Column { of, entries } = &columns[at];
    let pairs = match *of {
        Of::Whole(a) => [Some((a, None)), None],
        Of::Product(a, b) => [Some((a, Some(b))), Some((b, Some(a)))],
    };
    pairs.into_iter().flatten().filter_map(move |(a, by)| {
        let entry = known.rotations.entry(a)?;
        Some(Part {
            at,
            entry,
            error: known.value(a).error,
            by,
            entries: entries.map(|x| entry.sign * x),
        })
    })
}

/// Columns as A R v, where R is taken by its columns (axis 0) or by its rows.
fn together(parts: &[&Part], axis: usize) -> Option<Rotated> {
    /// More than rounding makes of numbers that are equal.
    const NEARLY: f64 = 1e-13;
    // For each entry of v the columns of λₖ A.
    let mut blocks = [[[0.0; ROWS]; 3]; 3];
    let mut given = [[false; 3]; 3];
    let mut values = [None; 3];
    for part in parts {
        let [i, k] = [part.entry.place[axis], part.entry.place[1 - axis]];
        let other = given[k] != [false; 3] && values[k] != part.by;
        if other || given[k][i] {
            return None;
        }
        (given[k][i], values[k], blocks[k][i]) = (true, part.by, part.entries);
    }
    let size = |block: &[[f64; ROWS]; 3]| root(block.iter().flatten().copied());
    let matrix = (blocks.into_iter()).max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let unit = size(&matrix);
    let factors = blocks.map(|block| {
        let pairs = block.iter().flatten().zip(matrix.iter().flatten());
        pairs.map(|(x, a)| (x / unit) * (a / unit)).sum::<f64>()
    });
    let is_product = blocks.iter().zip(factors).all(|(block, factor)| {
        let mut pairs = block.iter().flatten().zip(matrix.iter().flatten());
        pairs.all(|(x, a)| (x - factor * a).abs() <= NEARLY * unit)
    });
    (parts.len() > 1 && is_product).then(|| Rotated {
        values: values.into_iter().flatten().collect(),
        numbers: root(factors),
        matrix: matrix.to_vec(),
        error: root(parts.iter().map(|part| part.error)),
    })
}
