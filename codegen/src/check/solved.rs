//! What solves with the mass matrix, put back: torques of accelerations, M M⁻¹, M times derivatives.
//!
//! In: a robot at a state, and what a program found there. Out: the first entry that is not what was solved
//! for, beyond what the rounding of the description's own numbers and of the program's literals accounts
//! for. A solution may be far off where M is nearly singular, and yet solve its equation: that is what is
//! asked. It never solves anything.

use super::{UNBOUNDED, Wrong, wrong};
use crate::dense::{Approximate, Dense, ROUNDOFF};
use crate::list::{Id, List, Square};
use crate::space::{Variable, VelocityId};

/// How many times as far a solution may be from solving its equation as roundings of the
/// description's own numbers account for; and at most, where factors lose more than that.
const SOLVED: f64 = 1e3;
const HARDLY_SOLVED: f64 = 1e6;

/// The first joint that needs another torque for these accelerations than the one given.
pub(super) fn first_unsolved(dense: &Dense, found: &[Approximate]) -> Option<Wrong> {
    let qdd = found.iter().copied().map(Approximate::as_found);
    let torques = dense.torques_of(qdd.collect());
    let tau = dense.state.of_velocities(Variable::Tau);
    let found: List<VelocityId, Approximate> = found.iter().copied().collect();
    torques.numbered().find_map(|(row, torque)| {
        let tau = tau[row].to_f64();
        let distance = (torque.to_f64() - tau).abs();
        let most = most_unsolved(dense, row, *torque, &found);
        wrong(row.index(), torque.to_f64(), tau, distance <= most)
    })
}

/// The first entry of M M⁻¹ that is not of the identity.
pub(super) fn first_not_inverse(dense: &Dense, found: &[Approximate]) -> Option<Wrong> {
    let products = products(dense, &Square::of_rows(found));
    let mut places = products.places().enumerate();
    places.find_map(|(entry, (row, column))| {
        let Product { value, most } = products[(row, column)];
        let unit = if row == column { 1.0 } else { 0.0 };
        let distance = (value.to_f64() - unit).abs();
        wrong(entry, value.to_f64(), unit, distance <= most)
    })
}

/// The first entry of M ∂q̈/∂q and M ∂q̈/∂q̇ that is not what inverse dynamics changes by the other way, at the
/// accelerations that ∂q̈/∂τ makes of τ; or of M ∂q̈/∂τ that is not of the identity.
///
/// They are M⁻¹ times what torques change by, in a program as well: where large terms of that product cancel,
/// M takes back of each of them what it takes back of M⁻¹, and no more. A change that is nothing is nothing to a
/// program but for its literals: next to the largest change of that torque.
pub(super) fn first_wrong_derivative(dense: &Dense, found: &[Approximate]) -> Option<Wrong> {
    let size = found.len() / 3;
    let (by_motion, inverse) = found.split_at(2 * size);
    if let Some(wrong) = first_not_inverse(dense, inverse) {
        let entry = by_motion.len() + wrong.entry;
        return Some(Wrong { entry, ..wrong });
    }
    let bias = dense.coasting_torques();
    let lacking = dense.state.of_velocities(Variable::Tau).into_iter();
    let lacking = lacking.zip(bias).map(|(tau, bias)| tau - bias);
    let lacking: Vec<Approximate> = lacking.collect();
    let inverse = Square::of_rows(inverse);
    let accelerations = inverse.rows().map(|row| {
        let terms = row.into_iter().zip(&lacking);
        terms.fold(Approximate::exact(0.0), |sum, (x, y)| sum + x * *y)
    });
    let needed = dense.torque_derivatives_of(accelerations.collect());
    let put_back = products(dense, &inverse);
    let parts = needed.iter().zip(by_motion.chunks(size));
    let mut parts = parts.enumerate();
    parts.find_map(|(of, (needed, part))| {
        let row = |row| needed.row(row).map(Approximate::size).fold(0.0, f64::max);
        let largest: List<VelocityId, f64> = needed.ids().map(row).collect();
        let products = products(dense, &Square::of_rows(part));
        let mut places = products.places().enumerate();
        places.find_map(|(entry, (row, column))| {
            let Product { value, most } = products[(row, column)];
            let terms = put_back.ids();
            let taken = terms.map(|k| put_back[(row, k)].most * needed[(k, column)].size());
            let needed = -needed[(row, column)];
            let given = SOLVED * (needed.error + ROUNDOFF * largest[row]) + needed.noise();
            let most = most + taken.sum::<f64>() + given;
            // Nothing, of what may be infinitely wrong.
            let most = if most.is_nan() {
                UNBOUNDED * largest.iter().copied().fold(0.0, f64::max)
            } else {
                most
            };
            let distance = (value.value - needed.value).to_f64().abs();
            let entry = of * size + entry;
            wrong(entry, value.to_f64(), needed.to_f64(), distance <= most)
        })
    })
}

/// An entry of M times a matrix that was found.
#[derive(Clone, Copy)]
struct Product {
    value: Approximate,
    /// How far it may be from what it should be.
    most: f64,
}

/// M times a square matrix.
fn products(dense: &Dense, found: &Square<VelocityId, Approximate>) -> Square<VelocityId, Product> {
    let matrix = dense.mass_matrix();
    let column = |column: VelocityId| -> List<VelocityId, Product> {
        let solution = found.column(column);
        let row = |row: VelocityId| {
            let terms = matrix.row(row).zip(&solution);
            let value = terms.fold(Approximate::exact(0.0), |sum, (m, x)| {
                sum + m * x.as_found()
            });
            let most = most_unsolved(dense, row, value, &solution);
            Product { value, most }
        };
        solution.ids().map(row).collect()
    };
    Square::of_columns(&found.ids().map(column).collect())
}

/// How far a row of M x may be from what it should be: what x may be off by times M, and what the
/// roundings of the numbers in M, and of all that is solved for, amount to.
fn most_unsolved(
    dense: &Dense,
    row: VelocityId,
    found: Approximate,
    solution: &List<VelocityId, Approximate>,
) -> f64 {
    let matrix = dense.mass_matrix();
    let diagonal = |k: VelocityId| matrix[(k, k)].size();
    let mut most = SOLVED * found.error + found.noise();
    for (k, x) in solution.numbered() {
        let lost = ROUNDOFF * (diagonal(row) * diagonal(k)).sqrt() * x.size();
        // Not more than that of M may be lost on the way, however x itself is conditioned.
        let carried = (matrix[(row, k)].size() * x.error).min(HARDLY_SOLVED * lost);
        most += SOLVED * lost + carried;
    }
    most
}
