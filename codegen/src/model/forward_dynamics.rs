//! Joint accelerations of given joint forces and torques, from the mass matrix and the bias.
//!
//! In: the mass matrix, the tree, and what computes inverse dynamics. Out: q̈. A refinement takes
//! the inverse dynamics of what was found as the residual, which brings back the digits that forming
//! the mass matrix lost. It never knows in which frame either was computed.

use super::factor::factor;
use crate::expression::Term;

/// q̈ of τ, one entry a joint; `needed` is the inverse dynamics: τ of q̈.
///
/// τ is asked for only when it is needed, because what is older comes first in a sum.
pub fn forward_dynamics<'g>(
    matrix: &[Term<'g>],
    parents: &[Option<usize>],
    tau: impl Fn(usize) -> Term<'g>,
    needed: impl Fn(&[Term<'g>]) -> Vec<Term<'g>>,
    refinements: usize,
) -> Vec<Term<'g>> {
    let factors = factor(matrix, parents);
    let zero = matrix[0].graph().constant(0.0);
    let mut accelerations = vec![zero; parents.len()];
    for _ in 0..=refinements {
        let needed = needed(&accelerations);
        let needed = needed.into_iter().enumerate();
        let lacking: Vec<Term<'g>> = needed.map(|(k, needed)| tau(k) - needed).collect();
        let more = factors.solve(&lacking);
        for (acceleration, more) in accelerations.iter_mut().zip(more) {
            *acceleration = *acceleration + more;
        }
    }
    accelerations
}

/// The inverse of the mass matrix, row by row.
pub fn mass_matrix_inverse<'g>(matrix: &[Term<'g>], parents: &[Option<usize>]) -> Vec<Term<'g>> {
    let count = parents.len();
    let factors = factor(matrix, parents);
    let graph = matrix[0].graph();
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let mut entries = vec![zero; count * count];
    for column in 0..count {
        let mut unit = vec![zero; count];
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
pub fn pivots<'g>(matrix: &[Term<'g>], parents: &[Option<usize>]) -> Vec<Term<'g>> {
    let factors = factor(matrix, parents);
    let diagonal = matrix.iter().step_by(parents.len() + 1);
    diagonal
        .zip(factors.pivots)
        .flat_map(|(&entry, pivot)| [entry, pivot])
        .collect()
}
