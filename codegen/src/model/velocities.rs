//! From bodies to velocities, where bodies share one: a joint that follows another moves as that does,
//! times a factor, and what drives both drives the one velocity that they have.
//!
//! In: numbers of bodies, or of velocities. Out: those of the others. Where every body has its own
//! velocity, both are the same list, and nothing is computed.

use std::collections::BTreeSet;

use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::layout::Bodies;
use crate::list::{self, Id, List, Square};
use crate::space::VelocityId;

/// How many there are.
pub fn count(bodies: &Bodies<'_>) -> usize {
    let places = bodies.bodies.iter().map(|body| body.velocity.number());
    places.max().unwrap_or(0)
}

/// Of something that each velocity has, what each body makes of it.
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

/// What each velocity has of something that the bodies have.
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

/// The same of rows and columns of a matrix.
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

/// The same of a symmetric matrix.
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

/// The columns of a matrix whose rows are gathered: of each velocity, what the bodies have.
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

/// For each velocity the one that it is eliminated into: the nearest before it that its row of the mass
/// matrix has to do with, once all after it are eliminated (the elimination tree of sparse factors: Liu,
/// "The role of elimination trees in sparse factorization", 1990).
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
