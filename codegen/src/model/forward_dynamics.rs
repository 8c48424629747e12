//! Joint accelerations of given joint forces and torques, from the mass matrix and the bias.
//!
//! In: the bodies, and how often to refine. Out: q̈. A refinement takes the inverse dynamics of what
//! was found as the residual, which brings back the digits that forming the mass matrix lost.

use super::factor::{Factors, factor};
use super::newton_euler::inverse_dynamics;
use super::{State, composite};
use crate::chain::frames::Bodies;
use crate::expression::Term;

/// q̈ of τ, one entry a joint.
pub fn forward_dynamics<'g>(
    bodies: &Bodies<'g>,
    state: &State<'g>,
    refinements: usize,
) -> Vec<Term<'g>> {
    let count = bodies.bodies.len();
    let factors = factors(bodies, state);
    let mut accelerations = vec![state.zero(); count];
    for _ in 0..=refinements {
        let needed = inverse_dynamics(bodies, state, &accelerations);
        let lacking: Vec<Term<'g>> = (0..count).map(|k| state.tau(k) - needed[k]).collect();
        let more = factors.solve(&lacking);
        for (acceleration, more) in accelerations.iter_mut().zip(more) {
            *acceleration = *acceleration + more;
        }
    }
    accelerations
}

/// The inverse of the mass matrix, row by row.
pub fn mass_matrix_inverse<'g>(bodies: &Bodies<'g>, state: &State<'g>) -> Vec<Term<'g>> {
    let count = bodies.bodies.len();
    let factors = factors(bodies, state);
    let one = state.graph.constant(1.0);
    let mut entries = vec![state.zero(); count * count];
    for column in 0..count {
        let mut unit = vec![state.zero(); count];
        unit[column] = one;
        let solved = factors.solve(&unit);
        // The inverse is symmetric: what one column has, the others need not compute.
        for row in 0..=column {
            entries[row * count + column] = solved[row];
            entries[column * count + row] = solved[row];
        }
    }
    entries
}

/// For each joint the diagonal entry of the mass matrix and the pivot left of it.
pub fn pivots<'g>(bodies: &Bodies<'g>, state: &State<'g>) -> Vec<Term<'g>> {
    let matrix = composite::mass_matrix(bodies, state);
    let factors = factor(&matrix, &parents(bodies));
    let diagonal = matrix.iter().step_by(bodies.bodies.len() + 1);
    diagonal
        .zip(factors.pivots)
        .flat_map(|(&entry, pivot)| [entry, pivot])
        .collect()
}

fn parents(bodies: &Bodies<'_>) -> Vec<Option<usize>> {
    bodies.bodies.iter().map(|body| body.parent).collect()
}

fn factors<'g>(bodies: &Bodies<'g>, state: &State<'g>) -> Factors<'g> {
    factor(&composite::mass_matrix(bodies, state), &parents(bodies))
}
