//! Backward error of solutions by the factors of a mass matrix.
//!
//! In: a chain, and a program that computes the mass matrix and the torques, or their derivatives, as the
//! function does. Out: how far the torques, the derivatives or the mass matrix that a result is exact for
//! are from the given ones. The forward error is not bounded: it grows with the condition number.
//!
//! A computed solution of Lᵗ D L x = b solves M + ΔM exactly, with |ΔM| ≤ c u |Lᵗ| D |L| (as in Higham,
//! *Accuracy and Stability of Numerical Algorithms*, 2002, theorem 10.4), of which an entry is at most
//! c u √(Mᵢᵢ Mⱼⱼ) (Cauchy and Schwarz), as long as all pivots are positive. For n joints, c is
//! * n + 1 of the factors: from an entry n − 1 others are subtracted, each a product, 1, with a quotient that
//!   is a product with 1/D, 2; the first of them goes through n − 2 further differences;
//! * n − 1 of each of two substitutions, and 2 of x = y (1/D) between them;
//! * 1 of b = τ − bias, since b is M q̈; and 1 for all products of these.
//!
//! The accelerations of a floating base are solved for relative to its fall, and f is added: its error and the rounding
//! of the sum, Δq̈, are torques M Δq̈.
//!
//! Pivots are positive where M + ΔM is positive definite: with a bound S of |ΔM|, and
//! xᵢ² ≤ (M⁻¹)ᵢᵢ xᵗM x, that is where Σ Sᵢⱼ √((M⁻¹)ᵢᵢ (M⁻¹)ⱼⱼ) < 1.

use super::error_bounds::{Accuracy, Perturbed, RoundingModel, Worst, backward, computed, values};
use super::free_fall::{self, FreeFall};
use crate::accuracy::mobility::{Mobility, mobility};
use crate::chain::Chain;
use crate::layout::Layout;
use crate::range::Range;
use crate::real::Real;
use crate::schedule::Program;
use crate::schedule::bound::{Reason, Value};
use crate::space::Variable;

/// Reason why a solution has no bound if rounding may make its data wrong.
pub(super) const UNCERTAIN: &str = "rounding may outweigh the least inertia, as far as ranges tell";

/// The share of what keeps M positive definite that rounding may take: half, so that pivots whose sign is
/// uncertain are covered as well.
const SPOILT: f64 = 0.5;

/// Bounds the inverse of the mass matrix: each column from the diagonal up, which is solved for by itself.
/// The program computes the mass matrix.
#[must_use]
pub fn of_inverse(chain: &Chain, program: &Program, rounding: RoundingModel) -> Accuracy {
    let count = chain.spaces().velocities.len();
    let worst = |range: &Range, joints: &[f64], scalar: Real| -> Worst {
        let bounds = EquationBounds::of(program, range, joints, rounding, scalar)?;
        let entry = |k| bounds.lost(k / count, k % count);
        Ok((0..count * count).map(entry).collect())
    };
    of_solution(chain, Perturbed::MassMatrix, &[program], rounding, worst)
}

/// Bounds the inverse of the mass matrix after some refinements: each column from the diagonal up, as the
/// accelerations of a unit force. The program computes the mass matrix, and twice the torques of accelerations at rest
/// and without gravity: of zero accelerations, and of given ones.
#[must_use]
pub fn of_refined_inverse(
    chain: &Chain,
    program: &Program,
    refinements: usize,
    rounding: RoundingModel,
) -> Accuracy {
    let worst = |range: &Range, joints: &[f64], scalar: Real| -> Worst {
        // |(M⁻¹)ᵢⱼ| ≤ √((M⁻¹)ᵢᵢ (M⁻¹)ⱼⱼ).
        let column = |of: &f64| {
            let most = joints.iter().map(|most| (most * of).sqrt());
            with_accelerations(range, most.map(|most| [-most, most]))
        };
        let columns: Vec<Range> = joints.iter().map(column).collect();
        tried(0.0, |margin| {
            let bounds = columns.iter().map(|range| {
                EquationBounds::of(program, &widened(range, margin), joints, rounding, scalar)
            });
            let bounds = bounds.collect::<Result<Vec<EquationBounds>, _>>()?;
            let mut left: Vec<Vec<f64>> = bounds.iter().map(EquationBounds::unrefined).collect();
            for _ in 0..refinements {
                let off: Vec<Vec<f64>> = left.iter().map(|left| caused(joints, left)).collect();
                // Below the diagonal a column begins with the results of earlier columns.
                let before = |row: usize, column: usize| off[row.max(column)][row.min(column)];
                let columns = bounds.iter().enumerate().map(|(column, bounds)| {
                    let off: Vec<f64> = (0..joints.len()).map(|row| before(row, column)).collect();
                    bounds.refined(joints, &off, margin)
                });
                left = columns.collect::<Result<_, _>>()?;
            }
            let mut worst = vec![0.0; joints.len()];
            for (range, left) in columns.iter().zip(left) {
                if !stays(range, margin, &caused(joints, &left)) {
                    return Err(UNCERTAIN);
                }
                for (worst, left) in worst.iter_mut().zip(left) {
                    *worst = f64::max(*worst, left);
                }
            }
            Ok(worst)
        })
    };
    of_solution(chain, Perturbed::UnitForces, &[program], rounding, worst)
}

/// Bounds accelerations by the factors of the mass matrix, after some refinements. The first program computes the mass
/// matrix, the bias and the inverse dynamics, of accelerations relative to the fall of a floating base; the second that
/// fall.
#[must_use]
pub fn of_accelerations(
    chain: &Chain,
    programs @ [program, fall]: [&Program; 2],
    refinements: usize,
    rounding: RoundingModel,
) -> Accuracy {
    let worst = |range: &Range, joints: &[f64], scalar: Real| {
        let fall = FreeFall::of(fall, range, rounding, scalar)?;
        let relative = fall.relative(range);
        solved(
            program,
            &fall,
            &relative,
            joints,
            refinements,
            rounding,
            scalar,
        )
    };
    of_solution(chain, Perturbed::Torques, &programs, rounding, worst)
}

/// Bounds the derivatives of accelerations by coordinates and velocities: the error of the derivatives of τ, at the
/// accelerations found, for which each column is exact, with an M of its own as for a column of the inverse. The
/// first program computes the mass matrix and the torques at q̈ = 0, the second the derivatives by q and q̇ of the
/// torques that produce q̈, both relative to the fall of a floating base; the third that fall.
#[must_use]
pub fn of_derivatives(
    chain: &Chain,
    programs @ [equation, derivatives, fall]: [&Program; 3],
    rounding: RoundingModel,
) -> Accuracy {
    let worst = |range: &Range, joints: &[f64], scalar: Real| -> Worst {
        let fall = FreeFall::of(fall, range, rounding, scalar)?;
        let range = fall.relative(range);
        let narrow = EquationBounds::of(equation, &range, joints, rounding, scalar)?;
        tried(0.0, |margin| {
            let wider = widened(&range, margin);
            let off = narrow.over(&wider).unrefined();
            if !stays(&range, margin, &caused(joints, &off)) {
                return Err(UNCERTAIN);
            }
            let needed = values(computed(derivatives, &wider, rounding, scalar))?;
            narrow.differentiated(joints, &needed, &fall, scalar)
        })
    };
    of_solution(
        chain,
        Perturbed::TorqueDerivatives,
        &programs,
        rounding,
        worst,
    )
}

/// Bounds a solution. `worst` bounds it in a range, from the bounds of each velocity by the energy.
fn of_solution(
    chain: &Chain,
    perturbed: Perturbed,
    programs: &[&Program],
    rounding: RoundingModel,
    worst: impl Fn(&Range, &[f64], Real) -> Worst,
) -> Accuracy {
    let range = Range::of(chain);
    let mobility = mobility(chain, Layout::DESCRIBED, &range);
    backward(chain, perturbed, programs, rounding, |scalar| {
        let Mobility { joints, .. } = mobility.as_ref().map_err(|reason| *reason)?;
        worst(&range, joints, scalar)
    })
}

/// The largest accelerations that forces can cause, from |(M⁻¹)ᵢⱼ| ≤ √((M⁻¹)ᵢᵢ (M⁻¹)ⱼⱼ).
pub(super) fn caused(mobility: &[f64], forces: &[f64]) -> Vec<f64> {
    let roots = mobility.iter().map(|most| most.sqrt());
    let products = roots.clone().zip(forces).map(|(root, force)| root * force);
    let sum: f64 = products.sum();
    roots.map(|root| root * sum).collect()
}

/// Margins by which computed accelerations may exceed the range of the exact ones, as a share of it. They are tried
/// from the least.
const MARGINS: [f64; 4] = [1e-6, 1e-3, 0.03, 1.0];

/// A range of accelerations that is wider by a margin.
pub(super) fn widened(range: &Range, margin: f64) -> Range {
    let wider = |end: f64| end * (1.0 + margin);
    let accelerations = range.arguments[Variable::Qdd].iter();
    with_accelerations(range, accelerations.map(|ends| ends.map(wider)))
}

/// A range with other accelerations.
fn with_accelerations(range: &Range, accelerations: impl Iterator<Item = [f64; 2]>) -> Range {
    let mut changed = range.clone();
    changed.arguments[Variable::Qdd] = accelerations.collect();
    changed
}

/// The backward error after some refinements.
fn solved(
    program: &Program,
    fall: &FreeFall,
    range: &Range,
    mobility: &[f64],
    refinements: usize,
    rounding: RoundingModel,
    scalar: Real,
) -> Worst {
    let bounds = |range: &Range| EquationBounds::of(program, range, mobility, rounding, scalar);
    let narrow = bounds(range)?;
    let attempt = |margin: f64| -> Worst {
        let wider = widened(range, margin);
        // Only the residual of a refinement depends on accelerations.
        let bounds = if refinements == 0 {
            narrow.over(&wider)
        } else {
            bounds(&wider)?
        };
        let mut left = bounds.unrefined();
        for _ in 0..refinements {
            left = bounds.refined(mobility, &caused(mobility, &left), margin)?;
        }
        if !stays(range, margin, &caused(mobility, &left)) {
            return Err(UNCERTAIN);
        }
        let fallen = bounds.torques(&fall.lost(&wider));
        let both = left.into_iter().zip(fallen);
        Ok(both.map(|(left, fallen)| left + fallen).collect())
    };
    tried(0.0, attempt)
}

/// The bound with the first margin, from `least` up, that suffices.
pub(super) fn tried(least: f64, attempt: impl Fn(f64) -> Worst) -> Worst {
    let margins = MARGINS.into_iter().filter(|&margin| margin >= least);
    let attempts = margins.map(attempt);
    let mut refused = Err(UNCERTAIN);
    for found in attempts {
        if found.is_ok() || found != Err(UNCERTAIN) {
            return found;
        }
        refused = found;
    }
    refused
}

/// True if accelerations with these errors leave their range by no more than a margin.
pub(super) fn stays(range: &Range, margin: f64, off: &[f64]) -> bool {
    let most = range.arguments[Variable::Qdd]
        .iter()
        .map(|[_, most]| margin * most);
    off.iter().zip(most).all(|(off, most)| *off <= most)
}

/// The largest underflow of an intermediate sum, in any unit, if all factors of a product together are at most
/// `size`.
///
/// # Errors
/// If the product of two such numbers may overflow.
pub(super) fn underflow(size: f64, joints: usize, scalar: Real) -> Result<f64, &'static str> {
    let joints: f64 = std::iter::repeat_n(1.0, joints).sum();
    // An infinite size comes from a joint that can move without energy, which is reported instead.
    if size.is_finite() && joints * joints * size * size >= scalar.largest() {
        return Err(Reason::Overflow.words());
    }
    Ok(16.0 * joints * joints * size * scalar.smallest())
}

/// The size of the numbers that a solution x of given torques needs. Every intermediate result is at most a product of
/// two of these and of [`EquationBounds::factors`], as many times as there are joints, twice: factors are √(M/d), and
/// pivots d at least half of 1/(M⁻¹)ₖₖ.
fn solution(x: &[f64], given: impl Iterator<Item = f64>) -> f64 {
    largest(x.iter().copied()) * largest(given.map(|torque| 2.0 * torque))
}

/// The largest magnitude of each row of some matrices, by rows.
pub(super) fn largest_of_rows(entries: &[Value], count: usize) -> Vec<f64> {
    let mut most = vec![0.0_f64; count];
    for (k, entry) in entries.iter().enumerate() {
        let most = &mut most[k / count % count];
        *most = most.max(entry.reach() + entry.error);
    }
    most
}

/// The largest of some sizes and 1.
pub(super) fn largest(sizes: impl Iterator<Item = f64>) -> f64 {
    sizes.fold(1.0, f64::max)
}

/// Bounds of the values from which a program computes a solution.
#[derive(Clone)]
struct EquationBounds {
    roundoff: f64,
    /// The largest underflow of an intermediate sum, in any unit.
    vanishes: f64,
    /// The largest entry of the mass matrix times that of twice its inverse, which bounds the factors of the mass
    /// matrix.
    factors: f64,
    /// The largest magnitude of each acceleration.
    most: Vec<f64>,
    mass: Vec<Value>,
    bias: Vec<Value>,
    /// The torques and forces of given accelerations.
    needed: Vec<Value>,
}

impl EquationBounds {
    /// # Errors
    /// If one of them has no bound, or pivots may not be positive.
    fn of(
        program: &Program,
        range: &Range,
        mobility: &[f64],
        rounding: RoundingModel,
        scalar: Real,
    ) -> Result<Self, &'static str> {
        let most: Vec<f64> = range.arguments[Variable::Qdd]
            .iter()
            .map(|[_, most]| *most)
            .collect();
        let count = most.len();
        let mut mass = values(computed(program, range, rounding, scalar))?;
        let mut bias = mass.split_off(count * count);
        let needed = bias.split_off(count.min(bias.len()));
        let factors = largest(mass.iter().map(|value| value.reach()))
            * largest(mobility.iter().map(|most| 2.0 * most));
        let given = bias.iter().chain(&needed).map(|value| value.reach());
        let size = factors * solution(&most, given);
        let mut bounds = Self {
            roundoff: scalar.roundoff(),
            vanishes: 0.0,
            factors,
            most,
            mass,
            bias,
            needed,
        };
        // Pivots of unknown sign are the cause of unbounded numbers, so they are reported first.
        bounds.check(mobility)?;
        bounds.vanishes = underflow(size, count, scalar)?;
        bounds.check(mobility)?;
        Ok(bounds)
    }

    /// The same for another range of accelerations, on which no value here depends.
    fn over(&self, range: &Range) -> Self {
        Self {
            most: range.arguments[Variable::Qdd]
                .iter()
                .map(|[_, most]| *most)
                .collect(),
            ..self.clone()
        }
    }

    /// Checks that all pivots are positive.
    fn check(&self, mobility: &[f64]) -> Result<(), &'static str> {
        let roots: Vec<f64> = mobility.iter().map(|most| most.sqrt()).collect();
        let row = |(k, root): (usize, &f64)| {
            let entries = roots.iter().enumerate();
            let entries = entries.map(|(other, of)| self.lost(k, other) * root * of);
            entries.sum::<f64>()
        };
        let spoilt: f64 = roots.iter().enumerate().map(row).sum();
        // NaN is refused as well.
        if spoilt <= SPOILT {
            Ok(())
        } else {
            Err(UNCERTAIN)
        }
    }

    /// The total error of an entry of the mass matrix when a system is solved with it.
    fn lost(&self, row: usize, column: usize) -> f64 {
        let count = self.most.len();
        let size = |k: usize| self.mass[k * (count + 1)].reach();
        // c = 3n + 3.
        let roundings = self.most.iter().map(|_| 3.0).sum::<f64>() + 3.0;
        let solved = roundings * self.roundoff * (size(row) * size(column)).sqrt();
        self.mass[row * count + column].error + solved + self.vanishes
    }

    /// The errors of all entries, times a vector.
    fn lost_times(&self, x: &[f64]) -> Vec<f64> {
        let entries = |row: usize| {
            x.iter()
                .enumerate()
                .map(move |(k, x)| self.lost(row, k) * x)
        };
        (0..x.len()).map(|row| entries(row).sum()).collect()
    }

    /// The error of b, where M x = −b is solved for each column b of two matrices, row by row. x is at most
    /// M⁻¹ (b + ΔM x), of which the second term is at most half of x ([`SPOILT`]).
    fn differentiated(
        &self,
        mobility: &[f64],
        needed: &[Value],
        fall: &FreeFall,
        scalar: Real,
    ) -> Worst {
        let count = self.most.len();
        let most = largest_of_rows(needed, count);
        let x: Vec<f64> = caused(mobility, &most).iter().map(|x| 2.0 * x).collect();
        let size = self.factors * solution(&x, most.into_iter());
        let vanishes = underflow(size, count, scalar)?;
        let mass = |row: usize, column: usize| self.mass[row * count + column].reach();
        let fallen = free_fall::torques(&fall.lost_in_derivatives(&x), count, mass);
        let errors = needed.iter().zip(fallen);
        Ok(errors
            .map(|(b, fallen)| b.error + vanishes + fallen)
            .collect())
    }

    /// The backward error without refinement.
    fn unrefined(&self) -> Vec<f64> {
        let lost = self.lost_times(&self.most).into_iter();
        lost.zip(&self.bias)
            .map(|(lost, bias)| lost + bias.error + self.vanishes)
            .collect()
    }

    /// The backward error after a refinement, if the accelerations before it have the errors `off` and, as those
    /// after it, stay in a range that is wider than that of the exact ones by a margin.
    ///
    /// It consists of the rounding errors of the residual r and of the sum with the correction c, and ΔM c. The
    /// correction is M⁻¹ (r − ΔM c), of which M⁻¹ r is the error before it, plus M⁻¹ times the error of r.
    fn refined(&self, mobility: &[f64], off: &[f64], margin: f64) -> Worst {
        let rounded: Vec<f64> = self.needed.iter().map(|needed| needed.error).collect();
        // Twice M⁻¹ r, so that M⁻¹ ΔM c may be as large again.
        let correction = caused(mobility, &rounded).into_iter().zip(off);
        let correction: Vec<f64> = correction
            .map(|(by_residual, off)| 2.0 * (by_residual + off))
            .collect();
        let spoilt = self.lost_times(&correction);
        let again = caused(mobility, &spoilt);
        let most = self
            .most
            .iter()
            .map(|most| margin / 4.0 * most / (1.0 + margin));
        let mut all = correction.iter().zip(again).zip(most);
        // NaN is refused as well.
        if !all.all(|((&c, again), most)| again <= c / 2.0 && c <= most) {
            return Err(UNCERTAIN);
        }
        let sums = self.roundings_of_sums();
        let left = rounded.into_iter().zip(spoilt).zip(sums);
        Ok(left
            .map(|((rounded, spoilt), sum)| rounded + spoilt + sum)
            .collect())
    }

    /// The torques of the rounding errors of accelerations, once a correction has been added.
    fn roundings_of_sums(&self) -> Vec<f64> {
        let torques = self.torques(&self.most).into_iter();
        torques
            .map(|torque| self.roundoff * torque + self.vanishes)
            .collect()
    }

    /// The torques of accelerations of at most some magnitudes.
    fn torques(&self, most: &[f64]) -> Vec<f64> {
        let rows = self.mass.chunks(most.len());
        let torque = |row: &[Value]| {
            let terms = row.iter().zip(most);
            terms.map(|(entry, most)| entry.reach() * most).sum()
        };
        rows.map(torque).collect()
    }
}
