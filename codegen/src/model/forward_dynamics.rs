//! Forward dynamics from the mass matrix and the bias; and the inverse of the mass matrix, as the accelerations of unit
//! forces.
//!
//! In: the mass matrix, the tree, and a function for inverse dynamics. Out: q̈, or M⁻¹. A refinement takes the inverse
//! dynamics of the result as the residual, which restores the digits that the formation of the mass matrix lost.

use super::alike::alike;
use super::factor::factor;
use crate::expression::Term;
use crate::list::{Id, List, Square};
use crate::space::VelocityId;

/// q̈ for τ, one entry a joint; `needed` is the inverse dynamics: τ for q̈.
///
/// τ is read only when it is needed, because older terms come first in a sum.
pub fn forward_dynamics<'g>(
    matrix: &Square<VelocityId, Term<'g>>,
    parents: &List<VelocityId, Option<VelocityId>>,
    tau: impl Fn(VelocityId) -> Term<'g>,
    needed: impl Fn(&List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>>,
    refinements: usize,
) -> List<VelocityId, Term<'g>> {
    let factors = factor(matrix, parents);
    let zero = matrix.first().graph().constant(0.0);
    let mut accelerations = List::filled(zero, parents.len());
    for _ in 0..=refinements {
        let needed = needed(&accelerations);
        let residual = needed.numbered().map(|(k, &needed)| tau(k) - needed);
        let more = factors.solve(&residual.collect());
        for (acceleration, more) in accelerations.iter_mut().zip(more) {
            *acceleration = *acceleration + more;
        }
    }
    accelerations
}

/// The inverse of the mass matrix; `needed` is the inverse dynamics at rest without gravity: M q̈ for q̈.
pub fn mass_matrix_inverse<'g>(
    matrix: &Square<VelocityId, Term<'g>>,
    parents: &List<VelocityId, Option<VelocityId>>,
    needed: impl Fn(&List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>>,
    refinements: usize,
) -> Square<VelocityId, Term<'g>> {
    let factors = factor(matrix, parents);
    let graph = matrix.first().graph();
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let mut entries = Square::filled(zero, parents.len());
    for _ in 0..=refinements {
        let before = entries.clone();
        for column in parents.ids() {
            // The inverse is symmetric: entries of earlier columns are not computed again.
            let found = before.column(column);
            let needed = needed(&found);
            let unit = |row: VelocityId| if row == column { one } else { zero };
            let residual = needed.numbered().map(|(k, &needed)| unit(k) - needed);
            let more = factors.solve(&residual.collect());
            for row in parents.ids().take(column.number()) {
                entries.set_both((row, column), found[row] + more[row]);
            }
        }
    }
    entries
}

/// M⁻¹ times some columns, by the factors: on a tree they have zeros that the inverse has not.
pub fn solved<'g>(
    matrix: &Square<VelocityId, Term<'g>>,
    parents: &List<VelocityId, Option<VelocityId>>,
    columns: &[List<VelocityId, Term<'g>>],
) -> Vec<List<VelocityId, Term<'g>>> {
    let factors = factor(matrix, parents);
    let operations = parents.len().pow(2);
    alike(columns, operations, |column| factors.solve(column))
}

/// For each joint the diagonal entry of the mass matrix and its pivot.
pub fn pivots<'g>(
    matrix: &Square<VelocityId, Term<'g>>,
    parents: &List<VelocityId, Option<VelocityId>>,
) -> Vec<Term<'g>> {
    let factors = factor(matrix, parents);
    let diagonal = matrix.diagonal();
    diagonal
        .zip(factors.pivots)
        .flat_map(|(entry, pivot)| [entry, pivot])
        .collect()
}
