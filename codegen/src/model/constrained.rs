//! Accelerations of robots with closed loops, and the multipliers of the loops.
//!
//! In: the mass matrix, the tree, the forces τ − bias, and the Jacobian and bias of the loops; or the torques of a
//! motion, and which joints are actuated. Out: q̈ and λ of M q̈ = f + Jᵗ λ and J q̈ + γ = 0, by the Schur complement
//! S = J M⁻¹ Jᵗ; or the torques of those joints. Rows are eliminated in a given order. A row that depends on those before
//! it is left out: its λ is zero, and no division by a vanishing pivot occurs.

use std::ops::Deref;

use super::factor::factor;
use crate::expression::Term;
use crate::list::{List, Square};
use crate::space::VelocityId;

/// The equations of the loops.
pub struct Loops<'g> {
    /// J, by rows.
    pub jacobian: Vec<List<VelocityId, Term<'g>>>,
    /// γ.
    pub bias: Vec<Term<'g>>,
    /// For each row, the first row of its loop with the same unit.
    pub alike: Vec<usize>,
    /// The rows in the order in which they are eliminated.
    pub order: Vec<usize>,
    /// Ratio to the whole below which a diagonal entry of S counts as zero.
    pub zero_pivot: f64,
}

/// q̈ and λ; `forces` is f.
pub fn accelerations<'g>(
    matrix: &Square<VelocityId, Term<'g>>,
    parents: &List<VelocityId, Option<VelocityId>>,
    forces: &List<VelocityId, Term<'g>>,
    loops: &Loops<'g>,
) -> [Vec<Term<'g>>; 2] {
    let factors = factor(matrix, parents);
    // By M⁻¹ = (L⁻ᵗ)ᵗ D⁻¹ L⁻ᵗ, one half of each: of the forces, and of each row.
    let free = factors.half(forces);
    let halves: Vec<List<VelocityId, Term<'g>>> = (loops.jacobian.iter())
        .map(|row| factors.half(row))
        .collect();
    let by_pivots: Vec<List<VelocityId, Term<'g>>> =
        halves.iter().map(|half| factors.by_pivots(half)).collect();
    let wanted: Vec<Term<'g>> = (by_pivots.iter().zip(&loops.bias))
        .map(|(row, &bias)| -(dot(row, &free) + bias))
        .collect();
    let multipliers = multipliers(&halves, &by_pivots, &wanted, loops);
    let mut forced = free;
    for (half, &multiplier) in halves.iter().zip(&multipliers) {
        for (entry, &half) in forced.iter_mut().zip(half) {
            *entry = *entry + half * multiplier;
        }
    }
    [
        factors.other_half(&factors.by_pivots(&forced)).into(),
        multipliers,
    ]
}

/// τ of the actuated velocities, where `needed` is the torque of a motion at all velocities: λ balances the others, in
/// the least-squares sense.
pub fn actuated<'g>(
    needed: &List<VelocityId, Term<'g>>,
    actuated: &List<VelocityId, bool>,
    loops: &Loops<'g>,
) -> List<VelocityId, Term<'g>> {
    let passive = |of: &List<VelocityId, Term<'g>>| -> Vec<Term<'g>> {
        let entries = of.iter().zip(actuated).filter(|(_, actuated)| !**actuated);
        entries.map(|(&entry, _)| entry).collect()
    };
    let left = passive(needed);
    if left.is_empty() {
        return needed.clone();
    }
    let rows: Vec<Vec<Term<'g>>> = loops.jacobian.iter().map(passive).collect();
    let wanted: Vec<Term<'g>> = rows.iter().map(|row| dot(row, &left)).collect();
    let multipliers = multipliers(&rows, &rows, &wanted, loops);
    let torque = |k: VelocityId| {
        let held = loops.jacobian.iter().zip(&multipliers);
        held.fold(needed[k], |torque, (row, &multiplier)| {
            torque - row[k] * multiplier
        })
    };
    let zero = left[0].graph().constant(0.0);
    let velocities = actuated.numbered();
    velocities
        .map(|(k, &actuated)| if actuated { torque(k) } else { zero })
        .collect()
}

/// λ of S λ = y, where S is the product of the halves of its rows: S = L D Lᵗ, row after row in the order of
/// elimination.
fn multipliers<'g, R: Deref<Target = [Term<'g>]>>(
    halves: &[R],
    by_pivots: &[R],
    wanted: &[Term<'g>],
    loops: &Loops<'g>,
) -> Vec<Term<'g>> {
    let (count, order) = (halves.len(), &*loops.order);
    let diagonal: Vec<Term<'g>> = (0..count).map(|k| dot(&halves[k], &by_pivots[k])).collect();
    let whole = |k: usize| {
        let same = (0..count).filter(|&other| loops.alike[other] == loops.alike[k]);
        let sum = same
            .map(|other| diagonal[other])
            .reduce(|sum, entry| sum + entry);
        sum.expect("a row is measured with itself")
    };
    // L and L D, each below the diagonal, by columns; places are those of the order.
    let mut l: Vec<Vec<Term<'g>>> = Vec::with_capacity(count);
    let mut ld: Vec<Vec<Term<'g>>> = Vec::with_capacity(count);
    let mut inverse = Vec::with_capacity(count);
    for j in 0..count {
        let entry = |i: usize, first: Term<'g>| {
            let before = l.iter().zip(&ld).enumerate();
            before.fold(first, |entry, (k, (l, ld))| {
                entry - ld[i - k - 1] * l[j - k - 1]
            })
        };
        let pivot = entry(j, diagonal[order[j]]);
        inverse.push(guarded(pivot, whole(order[j]), loops.zero_pivot));
        let below: Vec<Term<'g>> = (j + 1..count)
            .map(|i| entry(i, dot(&halves[order[i]], &by_pivots[order[j]])))
            .collect();
        let own = below.iter().map(|&entry| entry * inverse[j]).collect();
        ld.push(below);
        l.push(own);
    }
    let mut x: Vec<Term<'g>> = order.iter().map(|&row| wanted[row]).collect();
    for k in 0..count {
        for i in k + 1..count {
            x[i] = x[i] - l[k][i - k - 1] * x[k];
        }
    }
    for k in (0..count).rev() {
        x[k] = x[k] * inverse[k];
        for i in k + 1..count {
            x[k] = x[k] - l[k][i - k - 1] * x[i];
        }
    }
    let mut multipliers = x.clone();
    for (&row, multiplier) in order.iter().zip(x) {
        multipliers[row] = multiplier;
    }
    multipliers
}

/// Added to a square so that it is not zero; below the rounding of any other square.
const LEAST: f64 = 1e-36;

/// 1/d, or 0 if d is negligible relative to the whole a: d / (d² + (ε a)²), and two Newton steps, which leave (ε a /
/// d)⁸ of its relative error.
fn guarded<'g>(d: Term<'g>, whole: Term<'g>, zero_pivot: f64) -> Term<'g> {
    let constant = |value: f64| d.graph().constant(value);
    let small = whole * constant(zero_pivot);
    let first = d / (d * d + small * small + constant(LEAST));
    let better = |x: Term<'g>| x * (constant(2.0) - d * x);
    better(better(first))
}

fn dot<'g>(a: &[Term<'g>], b: &[Term<'g>]) -> Term<'g> {
    let products = a.iter().zip(b).map(|(&a, &b)| a * b);
    let sum = products.reduce(|sum, product| sum + product);
    sum.expect("a robot has joints")
}
