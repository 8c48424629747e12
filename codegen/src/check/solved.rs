//! Check of solutions by their equation: torques of accelerations, M M⁻¹, M times derivatives.
//!
//! In: a robot at a state, and the results of a program there. Out: the first entry that does not solve its equation,
//! beyond the rounding of the description's own numbers and of the program's literals. A solution may be far off
//! where M is nearly singular and yet solve its equation, so only the equation is checked.

use super::{UNBOUNDED, Wrong, wrong};
use crate::dense::{Approximate, Dense, ROUNDOFF};
use crate::list::{Id, List, Square};
use crate::space::{Variable, VelocityId};

/// Largest residual of a solution, as a multiple of that which roundings of the description's own numbers explain; and
/// the limit if the factors lose more than that.
const SOLVED: f64 = 1e3;
const HARDLY_SOLVED: f64 = 1e6;

/// The first joint for which these accelerations need another torque than the given one.
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

/// The first entry of M M⁻¹ that is not that of the identity.
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

/// The first entry of M ∂q̈/∂q and M ∂q̈/∂q̇ that is not the negative derivative of inverse dynamics, at the
/// accelerations that ∂q̈/∂τ makes of τ; or of M ∂q̈/∂τ that is not that of the identity.
///
/// Programs compute them as M⁻¹ times derivatives of torques. If large terms of that product cancel, M restores each
/// of them as far as it restores the identity from M⁻¹, and no further. A derivative that is zero is zero for a
/// program only up to its literals: relative to the largest derivative of that torque.
pub(super) fn first_wrong_derivative(dense: &Dense, found: &[Approximate]) -> Option<Wrong> {
    let size = found.len() / 3;
    let (by_motion, inverse) = found.split_at(2 * size);
    if let Some(wrong) = first_not_inverse(dense, inverse) {
        let entry = by_motion.len() + wrong.entry;
        return Some(Wrong { entry, ..wrong });
    }
    let right_side = dense.unbalanced_torques();
    let inverse = Square::of_rows(inverse);
    let accelerations = inverse.rows().map(|row| {
        let terms = row.into_iter().zip(&right_side);
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
            let restored = terms.map(|k| put_back[(row, k)].most * needed[(k, column)].size());
            let needed = -needed[(row, column)];
            let given = SOLVED * (needed.error + ROUNDOFF * largest[row]) + needed.noise();
            let most = most + restored.sum::<f64>() + given;
            // A bound is NaN if a zero is multiplied by an infinite error.
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

/// The first entry that is not the expected one, beyond what roundings of the description's own numbers explain.
pub(super) fn first_unlike(expected: &[Approximate], found: &[Approximate]) -> Option<Wrong> {
    let sizes = expected.iter().map(|entry| entry.size());
    let largest = sizes.fold(0.0, f64::max);
    let mut pairs = found.iter().zip(expected).enumerate();
    pairs.find_map(|(entry, (found, expected))| {
        // Programs that lose more than half of the digits are refused, and the bound of the error is far above that. A
        // bound that is NaN, of a zero times an infinite error, is none.
        let given = SOLVED * (expected.error + ROUNDOFF * largest);
        let given = given.min(UNBOUNDED * largest);
        let noise = found.as_found().noise() + expected.noise();
        let most = given + if noise.is_finite() { noise } else { 0.0 };
        let distance = (found.value - expected.value).to_f64().abs();
        let (found, expected) = (found.to_f64(), expected.to_f64());
        wrong(entry, found, expected, distance <= most)
    })
}

/// An entry of M times a computed matrix.
#[derive(Clone, Copy)]
struct Product {
    value: Approximate,
    /// Its largest allowed error.
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

/// The largest allowed error of a row of M x: the error of x times M, plus the rounding of the numbers in M and of the
/// solution.
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
        // The loss on the way is limited to this share of M, however x itself is conditioned.
        let carried = (matrix[(row, k)].size() * x.error).min(HARDLY_SOLVED * lost);
        most += SOLVED * lost + carried;
    }
    most
}
