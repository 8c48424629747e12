//! M = Lᵗ D L of a mass matrix, with the zeros of a tree (Featherstone, "Efficient factorization of the joint-space
//! inertia matrix for branched kinematic trees", 2005).
//!
//! In: the mass matrix and the tree. Out: factors that solve M x = b without fill-in. There is no pivoting: M is
//! positive definite, or the chain has been refused.

use crate::expression::{Block, Component, LabelledBodies, Term};
use crate::list::{List, Square};
use crate::space::VelocityId;

/// L (unit lower triangular) and D⁻¹.
pub struct Factors<'g> {
    /// For each velocity, its ancestors in the elimination, nearest first, with the entry of L.
    rows: List<VelocityId, Vec<(VelocityId, Term<'g>)>>,
    /// D.
    pub pivots: List<VelocityId, Term<'g>>,
    /// The reciprocals of D.
    inverse: List<VelocityId, Term<'g>>,
}

/// Factors a mass matrix; `parents` has for each velocity its parent in the elimination.
pub fn factor<'g>(
    matrix: &Square<VelocityId, Term<'g>>,
    parents: &List<VelocityId, Option<VelocityId>>,
) -> Factors<'g> {
    let mut entries = matrix.clone();
    let inboard: List<VelocityId, Vec<VelocityId>> =
        parents.map(|&parent| std::iter::successors(parent, |&at| parents[at]).collect());
    let one = matrix.first().graph().constant(1.0);
    let mut pivots = List::filled(one, parents.len());
    let mut inverse = pivots.clone();
    let mut rows = List::filled(Vec::new(), parents.len());
    for k in parents.ids().rev() {
        let pivot = entries[(k, k)];
        pivot.label(
            Block::Pivot
                .of(LabelledBodies::Body(k.into()))
                .entry(Component::Scalar),
        );
        pivots[k] = pivot;
        inverse[k] = one / pivot;
        for (nearest, &i) in inboard[k].iter().enumerate() {
            let entry = entries[(k, i)];
            let l = entry * inverse[k];
            l.label(
                Block::Factor
                    .of(LabelledBodies::Pair(k.into(), i.into()))
                    .entry(Component::Scalar),
            );
            for &j in &inboard[k][nearest..] {
                let changed = entries[(i, j)] - l * entries[(k, j)];
                entries.set_both((i, j), changed);
            }
            rows[k].push((i, l));
        }
    }
    Factors {
        rows,
        pivots,
        inverse,
    }
}

impl<'g> Factors<'g> {
    /// x of Lᵗ D L x = b.
    pub fn solve(&self, b: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        let mut x = self.half(b);
        for k in b.ids() {
            x[k] = x[k] * self.inverse[k];
            for &(i, l) in &self.rows[k] {
                x[k] = x[k] - l * x[i];
            }
        }
        x
    }

    /// x of Lᵗ x = b.
    pub fn half(&self, b: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        let mut x = b.clone();
        for k in b.ids().rev() {
            for &(i, l) in &self.rows[k] {
                x[i] = x[i] - l * x[k];
            }
        }
        x
    }

    /// D⁻¹ x.
    pub fn by_pivots(&self, x: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        let entries = x.iter().zip(&self.inverse);
        entries.map(|(&entry, &inverse)| entry * inverse).collect()
    }

    /// x of L x = b.
    pub fn other_half(&self, b: &List<VelocityId, Term<'g>>) -> List<VelocityId, Term<'g>> {
        let mut x = b.clone();
        for k in b.ids() {
            for &(i, l) in &self.rows[k] {
                x[k] = x[k] - l * x[i];
            }
        }
        x
    }
}
