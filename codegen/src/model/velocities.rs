//! From bodies to velocities, where bodies share one: a joint that follows another moves as that does,
//! times a factor, and what drives both drives the one velocity that they have.
//!
//! In: numbers of bodies, or of velocities. Out: those of the others. Where every body has its own
//! velocity, both are the same list, and nothing is computed.

use std::collections::BTreeSet;

use super::state::State;
use crate::expression::Term;
use crate::layout::Bodies;

/// How many there are.
pub fn count(bodies: &Bodies<'_>) -> usize {
    let places = bodies.bodies.iter().map(|body| body.velocity + 1);
    places.max().unwrap_or(0)
}

/// Of something that each velocity has, what each body makes of it.
pub fn shared<'g>(state: &State<'g>, bodies: &Bodies<'g>, of: &[Term<'g>]) -> Vec<Term<'g>> {
    let bodies = 0..bodies.bodies.len();
    bodies
        .map(|k| state.times_factor(k, of[state.velocity(k)]))
        .collect()
}

/// What each velocity has of something that the bodies have.
pub fn gathered<'g>(state: &State<'g>, bodies: &Bodies<'g>, of: &[Term<'g>]) -> Vec<Term<'g>> {
    let mut sums: Vec<Option<Term<'g>>> = vec![None; count(bodies)];
    for (k, &term) in of.iter().enumerate() {
        let term = state.times_factor(k, term);
        let sum = &mut sums[state.velocity(k)];
        *sum = Some(sum.map_or(term, |sum| sum + term));
    }
    let zero = || state.zero();
    sums.into_iter()
        .map(|sum| sum.unwrap_or_else(zero))
        .collect()
}

/// The same of rows and columns of a matrix.
pub fn gathered_by_both<'g>(
    state: &State<'g>,
    bodies: &Bodies<'g>,
    matrix: Vec<Term<'g>>,
) -> Vec<Term<'g>> {
    let count = count(bodies);
    if count == bodies.bodies.len() {
        return matrix;
    }
    let rows = matrix.chunks(bodies.bodies.len());
    let rows: Vec<Vec<Term<'g>>> = rows.map(|row| gathered(state, bodies, row)).collect();
    let columns = (0..count).map(|k| {
        let column: Vec<Term<'g>> = rows.iter().map(|row| row[k]).collect();
        gathered(state, bodies, &column)
    });
    let columns: Vec<Vec<Term<'g>>> = columns.collect();
    let rows = (0..count).flat_map(|row| columns.iter().map(move |column| column[row]));
    rows.collect()
}

/// The same of a symmetric matrix.
pub fn gathered_twice<'g>(
    state: &State<'g>,
    bodies: &Bodies<'g>,
    matrix: Vec<Term<'g>>,
) -> Vec<Term<'g>> {
    let count = count(bodies);
    if count == bodies.bodies.len() {
        return matrix;
    }
    let rows = matrix.chunks(bodies.bodies.len());
    let rows: Vec<Vec<Term<'g>>> = rows.map(|row| gathered(state, bodies, row)).collect();
    let column = |k: usize| -> Vec<Term<'g>> {
        let column: Vec<Term<'g>> = rows.iter().map(|row| row[k]).collect();
        gathered(state, bodies, &column)
    };
    let mut matrix = vec![state.zero(); count * count];
    for k in 0..count {
        // Both halves are the same terms.
        for (row, entry) in column(k).into_iter().enumerate().take(k + 1) {
            matrix[row * count + k] = entry;
            matrix[k * count + row] = entry;
        }
    }
    matrix
}

/// For each velocity the one that it is eliminated into: the nearest before it that its row of the mass
/// matrix has to do with, once all after it are eliminated (the elimination tree of sparse factors: Liu,
/// "The role of elimination trees in sparse factorization", 1990).
pub fn parents(bodies: &Bodies<'_>) -> Vec<Option<usize>> {
    let mut before: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); count(bodies)];
    for body in &bodies.bodies {
        let inwards = |parent: &usize| bodies.bodies[*parent].parent;
        for carrying in std::iter::successors(body.parent, inwards) {
            let pair = [body.velocity, bodies.bodies[carrying].velocity];
            let [first, last] = [pair[0].min(pair[1]), pair[0].max(pair[1])];
            if first < last {
                before[last].insert(first);
            }
        }
    }
    let mut parents = vec![None; before.len()];
    for k in (0..before.len()).rev() {
        let mut row = std::mem::take(&mut before[k]);
        if let Some(parent) = row.pop_last() {
            before[parent].extend(row);
            parents[k] = Some(parent);
        }
    }
    parents
}
