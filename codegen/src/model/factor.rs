//! M = Lᵗ D L of a mass matrix, with the zeros that a tree leaves (Featherstone, "Efficient
//! factorization of the joint-space inertia matrix for branched kinematic trees", 2005).
//!
//! In: the mass matrix and the tree. Out: factors that solve M x = b without filling a zero in. It
//! never pivots: M is positive definite, or the chain has been refused.

use crate::expression::Term;

/// L (unit lower triangular) and D⁻¹.
pub struct Factors<'g> {
    /// For each joint, the joints inboard of it, nearest first, with the entry of L.
    rows: Vec<Vec<(usize, Term<'g>)>>,
    /// D.
    pub pivots: Vec<Term<'g>>,
    /// The reciprocals of D.
    inverse: Vec<Term<'g>>,
}

/// Factors a mass matrix given row by row; `parents` are the joints' parents.
pub fn factor<'g>(matrix: &[Term<'g>], parents: &[Option<usize>]) -> Factors<'g> {
    let count = parents.len();
    let mut entries = matrix.to_vec();
    let inboard: Vec<Vec<usize>> = (0..count)
        .map(|k| std::iter::successors(parents[k], |&at| parents[at]).collect())
        .collect();
    let one = matrix[0].graph().constant(1.0);
    let mut pivots = vec![one; count];
    let mut inverse = vec![one; count];
    let mut rows = vec![Vec::new(); count];
    for k in (0..count).rev() {
        let pivot = entries[k * count + k];
        pivot.label(|| format!("d_{}", k + 1));
        pivots[k] = pivot;
        inverse[k] = one / pivot;
        for (nearest, &i) in inboard[k].iter().enumerate() {
            let entry = entries[k * count + i];
            let l = entry * inverse[k];
            l.label(|| format!("l_{}_{}", k + 1, i + 1));
            for &j in &inboard[k][nearest..] {
                let changed = entries[i * count + j] - l * entries[k * count + j];
                entries[i * count + j] = changed;
                entries[j * count + i] = changed;
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
    pub fn solve(&self, b: &[Term<'g>]) -> Vec<Term<'g>> {
        let mut x = self.half(b);
        for (k, &inverse) in self.inverse.iter().enumerate() {
            x[k] = x[k] * inverse;
            for &(i, l) in &self.rows[k] {
                x[k] = x[k] - l * x[i];
            }
        }
        x
    }

    /// x of Lᵗ x = b.
    pub fn half(&self, b: &[Term<'g>]) -> Vec<Term<'g>> {
        let mut x = b.to_vec();
        for k in (0..x.len()).rev() {
            for &(i, l) in &self.rows[k] {
                x[i] = x[i] - l * x[k];
            }
        }
        x
    }

    /// D⁻¹ x.
    pub fn weighed(&self, x: &[Term<'g>]) -> Vec<Term<'g>> {
        let entries = x.iter().zip(&self.inverse);
        entries.map(|(&entry, &inverse)| entry * inverse).collect()
    }

    /// x of L x = b.
    pub fn other_half(&self, b: &[Term<'g>]) -> Vec<Term<'g>> {
        let mut x = b.to_vec();
        for k in 0..x.len() {
            for &(i, l) in &self.rows[k] {
                x[k] = x[k] - l * x[i];
            }
        }
        x
    }
}
