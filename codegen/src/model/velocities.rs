//! Conversion between bodies and velocities, if bodies share one: a mimic joint moves with its mimicked joint, times a
//! factor, and the torques of both add up at the velocity that they share.
//!
//! In: values of bodies, or of velocities. Out: those of the other. If every body has its own velocity, both are the
//! same list, and nothing is computed.

use std::collections::BTreeSet;

use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::layout::Bodies;
use crate::list::{self, Id, List, Square};
use crate::space::VelocityId;

/// The number of velocities.
pub fn count(bodies: &Bodies<'_>) -> usize {
    let places = bodies.bodies.iter().map(|body| body.velocity.number());
    places.max().unwrap_or(0)
}

/// The values of each body, from those of each velocity.
pub fn shared<'g>(
    state: &State<'g>,
    bodies: &Bodies<'g>,
    of: &List<VelocityId, Term<'g>>,
) -> List<BodyId, Term<'g>> {
    let bodies = bodies.bodies.ids();
    bodies
        .map(|k| state.times_factor(k, of[state.velocity(k)]))
        .collect()
}

/// The values of each velocity, summed over the bodies.
pub fn gathered<'g>(
    state: &State<'g>,
    bodies: &Bodies<'g>,
    of: &List<BodyId, Term<'g>>,
) -> List<VelocityId, Term<'g>> {
    let mut sums: List<VelocityId, Option<Term<'g>>> = List::filled(None, count(bodies));
    for (k, &term) in of.numbered() {
        let term = state.times_factor(k, term);
        let sum = &mut sums[state.velocity(k)];
        *sum = Some(sum.map_or(term, |sum| sum + term));
    }
    sums.map(|sum| sum.unwrap_or_else(|| state.zero()))
}

/// The same for rows and columns of a matrix.
pub fn gathered_by_both<'g>(
    state: &State<'g>,
    bodies: &Bodies<'g>,
    matrix: Square<BodyId, Term<'g>>,
) -> Square<VelocityId, Term<'g>> {
    if count(bodies) == bodies.bodies.len() {
        return matrix.renumbered();
    }
    Square::of_columns(
        &half_gathered(state, bodies, &matrix).map(|column| gathered(state, bodies, column)),
    )
}

/// The same for a symmetric matrix.
pub fn gathered_twice<'g>(
    state: &State<'g>,
    bodies: &Bodies<'g>,
    matrix: Square<BodyId, Term<'g>>,
) -> Square<VelocityId, Term<'g>> {
    let count = count(bodies);
    if count == bodies.bodies.len() {
        return matrix.renumbered();
    }
    let mut found = Square::filled(state.zero(), count);
    for (k, column) in half_gathered(state, bodies, &matrix).numbered() {
        let column = gathered(state, bodies, column);
        // Both halves are the same terms.
        for (row, &entry) in column.numbered().take(k.number()) {
            found.set_both((row, k), entry);
        }
    }
    found
}

/// The columns of a matrix whose rows are gathered: for each velocity, the values of the bodies.
fn half_gathered<'g>(
    state: &State<'g>,
    bodies: &Bodies<'g>,
    matrix: &Square<BodyId, Term<'g>>,
) -> List<VelocityId, List<BodyId, Term<'g>>> {
    let rows: List<BodyId, _> = matrix
        .rows()
        .map(|row| gathered(state, bodies, &row))
        .collect();
    let velocities = list::ids(count(bodies));
    velocities.map(|k| rows.map(|row| row[k])).collect()
}

/// For each velocity its parent in the elimination: the nearest before it that its row of the mass matrix is coupled
/// with, once all after it are eliminated (the elimination tree of sparse factors: Liu, "The role of elimination trees
/// in sparse factorization", 1990).
pub fn parents(bodies: &Bodies<'_>) -> List<VelocityId, Option<VelocityId>> {
    let mut before = List::<VelocityId, _>::filled(BTreeSet::new(), count(bodies));
    for body in &bodies.bodies {
        let inwards = |&parent: &BodyId| bodies.bodies[parent].parent;
        for carrying in std::iter::successors(body.parent, inwards) {
            let pair = [body.velocity, bodies.bodies[carrying].velocity];
            let [first, last] = [pair[0].min(pair[1]), pair[0].max(pair[1])];
            if first < last {
                before[last].insert(first);
            }
        }
    }
    let mut parents = List::filled(None, before.len());
    for k in before.ids().rev() {
        let mut row = std::mem::take(&mut before[k]);
        if let Some(parent) = row.pop_last() {
            before[parent].extend(row);
            parents[k] = Some(parent);
        }
    }
    parents
}
