//! What is solved exactly where a mass matrix is factored.
//!
//! In: a chain, and a program that computes the mass matrix and the torques as the function does.
//! Out: how far the torques, or the mass matrix, that a result is exact for are from those given
//! (backward error). It never says how far the result is off: that grows with the condition number.
//!
//! A computed solution solves M + ΔM with |ΔM| ≤ γ |Lᵗ| D |L| exactly (Higham, *Accuracy and
//! Stability of Numerical Algorithms*, 2002, theorem 10.4), of which an entry is at most
//! γ √(Mᵢᵢ Mⱼⱼ), since M is positive definite.

use super::{Accuracy, Given, backward, by_unit, slides, value};
use crate::chain::Chain;
use crate::chain::mobility::mobility;
use crate::chain::range::Range;
use crate::expression::Input;
use crate::function::Function;
use crate::request::Real;
use crate::schedule::Program;
use crate::schedule::bound::{self, Value};

/// Of the inverse of the mass matrix: of each column from the diagonal up, which is solved for by
/// itself. The program computes the mass matrix.
#[must_use]
pub fn of_inverse(chain: &Chain, parts: &Program, scalar: Real) -> Accuracy {
    let range = Range::of(chain);
    let count = chain.joints.len();
    let worst = |scalar: Real| -> Vec<f64> {
        let found = Parts::of(parts, &range, scalar);
        let entry = |k| found.lost(k / count, k % count);
        (0..count * count).map(entry).collect()
    };
    let units = Function::MassMatrix.units(&slides(chain));
    backward(chain, Given::MassMatrix, by_unit(units, scalar, worst))
}

/// Of accelerations by the factors of the mass matrix, refined so often. The program computes the
/// mass matrix, the bias and the inverse dynamics.
#[must_use]
pub fn of_accelerations(
    chain: &Chain,
    parts: &Program,
    refinements: usize,
    scalar: Real,
) -> Accuracy {
    let range = Range::of(chain);
    let mobility = (refinements > 0).then(|| mobility(chain)).flatten();
    let worst = |scalar: Real| match (refinements, &mobility) {
        (0, _) => Parts::of(parts, &range, scalar).unrefined(),
        (_, Some(mobility)) => refined(parts, &range, mobility, refinements, scalar),
        (_, None) => vec![f64::INFINITY; range.qdd.len()],
    };
    let units = Function::InverseDynamics.units(&slides(chain));
    backward(chain, Given::Torques, by_unit(units, scalar, worst))
}

/// What is left after some refinements; infinite where they may not converge, as far as ranges tell.
///
/// Each leaves what rounding takes from its residual and from the sum with the correction, and ΔM
/// times the correction c. That is at most M⁻¹ (r + ΔM c), where r bounds the residual; an entry of
/// M⁻¹ is at most the root of the product of two diagonal ones.
fn refined(
    parts: &Program,
    range: &Range,
    mobility: &[f64],
    refinements: usize,
    scalar: Real,
) -> Vec<f64> {
    let accelerations = |forces: &[f64]| -> Vec<f64> {
        let roots = mobility.iter().map(|most| most.sqrt());
        let sum: f64 = roots
            .clone()
            .zip(forces)
            .map(|(root, force)| root * force)
            .sum();
        roots.map(|root| root * sum).collect()
    };
    // What is found before the last refinement may be out of the range by what it corrects.
    let attempt = |margin: f64| -> Option<Vec<f64>> {
        let wider = |end: f64| end * (1.0 + margin);
        let wider = Range {
            qdd: range.qdd.iter().map(|ends| ends.map(wider)).collect(),
            ..range.clone()
        };
        let parts = Parts::of(parts, &wider, scalar);
        let mut left = parts.unrefined();
        for _ in 0..refinements {
            let residual: Vec<f64> = (left.iter().zip(&parts.needed))
                .map(|(left, needed)| left + needed.error)
                .collect();
            // Twice M⁻¹ r, so that M⁻¹ ΔM c may be as much again.
            let correction = accelerations(&residual).into_iter().map(|c| 2.0 * c);
            let correction: Vec<f64> = correction.collect();
            let spoilt = parts.lost_times(&correction);
            let again = accelerations(&spoilt);
            let most = range.qdd.iter().map(|[_, most]| margin / 4.0 * most);
            let mut all = correction.iter().zip(again).zip(most);
            // What is not a number is not within anything.
            if !all.all(|((&c, again), most)| again <= c / 2.0 && c <= most) {
                return None;
            }
            let sums = parts.roundings_of_sums();
            left = (parts.needed.iter().zip(spoilt).zip(sums))
                .map(|((needed, spoilt), sum)| needed.error + spoilt + sum)
                .collect();
        }
        Some(left)
    };
    let margins = [1e-6, 1e-3, 0.03, 1.0];
    let left = margins.into_iter().find_map(attempt);
    left.unwrap_or_else(|| vec![f64::INFINITY; mobility.len()])
}

/// What a program computes that a solution comes from.
struct Parts {
    roundoff: f64,
    /// The greatest that each acceleration can be.
    most: Vec<f64>,
    mass: Vec<Value>,
    bias: Vec<Value>,
    /// The torques and forces of given accelerations.
    needed: Vec<Value>,
}

impl Parts {
    fn of(program: &Program, range: &Range, scalar: Real) -> Self {
        let most: Vec<f64> = range.qdd.iter().map(|[_, most]| *most).collect();
        let count = most.len();
        let input = |input: Input| value(range, input, scalar);
        let mut mass = bound::results(program, scalar, &input);
        let mut rest = mass.split_off(count * count);
        let needed = rest.split_off(count.min(rest.len()));
        Self {
            roundoff: scalar.roundoff(),
            most,
            mass,
            bias: rest,
            needed,
        }
    }

    /// What is lost of an entry of the mass matrix until something is solved.
    fn lost(&self, row: usize, column: usize) -> f64 {
        let count = self.most.len();
        let size = |k: usize| self.mass[k * (count + 1)].reach();
        // Factors and two substitutions, 3n + 1; quotients as products with a reciprocal, 3; the
        // difference of torques and bias, 1; and 1 for all products of these.
        let roundings = self.most.iter().map(|_| 3.0).sum::<f64>() + 6.0;
        let solved = roundings * self.roundoff * (size(row) * size(column)).sqrt();
        self.mass[row * count + column].error + solved
    }

    /// The same of all entries, times a vector.
    fn lost_times(&self, x: &[f64]) -> Vec<f64> {
        let entries = |row: usize| {
            x.iter()
                .enumerate()
                .map(move |(k, x)| self.lost(row, k) * x)
        };
        (0..x.len()).map(|row| entries(row).sum()).collect()
    }

    /// Of what is not refined.
    fn unrefined(&self) -> Vec<f64> {
        let lost = self.lost_times(&self.most).into_iter();
        lost.zip(&self.bias)
            .map(|(lost, bias)| lost + bias.error)
            .collect()
    }

    /// What the accelerations take when they are rounded, once a correction has been added.
    fn roundings_of_sums(&self) -> Vec<f64> {
        let count = self.most.len();
        let entries = |row: usize| &self.mass[row * count..][..count];
        let torque = |row: usize| {
            let terms = entries(row).iter().zip(&self.most);
            self.roundoff * terms.map(|(entry, most)| entry.reach() * most).sum::<f64>()
        };
        (0..count).map(torque).collect()
    }
}
