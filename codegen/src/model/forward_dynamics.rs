//! Joint accelerations of given joint forces and torques, from the mass matrix and the bias; and the
//! accelerations of unit forces, which are the inverse of the mass matrix.
//!
//! In: the mass matrix, the tree, and what computes inverse dynamics. Out: q̈, or M⁻¹. A refinement
//! takes the inverse dynamics of what was found as the residual, which brings back the digits that
//! forming the mass matrix lost. It never knows in which frame either was computed.

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

/// The inverse of the mass matrix, row by row; `needed` is the inverse dynamics at rest without
/// gravity: M q̈ of q̈.
pub fn mass_matrix_inverse<'g>(
    matrix: &[Term<'g>],
    parents: &[Option<usize>],
    needed: impl Fn(&[Term<'g>]) -> Vec<Term<'g>>,
    refinements: usize,
) -> Vec<Term<'g>> {
    let count = parents.len();
    let factors = factor(matrix, parents);
    let graph = matrix[0].graph();
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let mut entries = vec![zero; count * count];
    for _ in 0..=refinements {
        let before = entries.clone();
        for column in 0..count {
            // The inverse is symmetric: what one column has, the others need not compute.
            let found = &before[column * count..][..count];
            let needed = needed(found).into_iter().enumerate();
            let unit = |row: usize| if row == column { one } else { zero };
            let lacking: Vec<Term<'g>> = needed.map(|(k, needed)| unit(k) - needed).collect();
            let more = factors.solve(&lacking);
            for row in 0..=column {
                let entry = found[row] + more[row];
                entries[row * count + column] = entry;
                entries[column * count + row] = entry;
            }
        }
    }
    entries
}

/// M⁻¹ of a square matrix, row by row, column by column from the factors: on a tree they have zeros that
/// the inverse has not.
pub fn solved<'g>(
    matrix: &[Term<'g>],
    parents: &[Option<usize>],
    of: &[Term<'g>],
) -> Vec<Term<'g>> {
    let count = parents.len();
    let factors = factor(matrix, parents);
    let mut found = of.to_vec();
    for column in 0..count {
        let given: Vec<Term<'g>> = (0..count).map(|row| of[row * count + column]).collect();
        for (row, entry) in factors.solve(&given).into_iter().enumerate() {
            found[row * count + column] = entry;
        }
    }
    found
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
