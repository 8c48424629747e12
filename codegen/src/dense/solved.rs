//! Solutions of M x = b by elimination: accelerations, and their contracted derivatives.
//!
//! In: a [`Dense`]. Out: q̈, M⁻¹, and the first and second derivatives of λᵀq̈; `None` if M is singular. Those follow from
//! derivatives of τ: with y = M⁻¹ λ, the derivative of λᵀq̈ is that of −yᵀτ at constant q̈.

use super::products::{GeneralizedVector, row_times, times_column};
use super::{Approximate, Dense, ROUNDOFF};
use crate::list::Square;
use crate::space::{Variable, VelocityId};

impl Dense {
    /// X of M X = B, row by row, by elimination with the largest pivot.
    pub(crate) fn eliminated(
        &self,
        mut right: Vec<Vec<Approximate>>,
    ) -> Option<Vec<Vec<Approximate>>> {
        let rows = self.mass_matrix().rows();
        let mut left: Vec<Vec<Approximate>> = rows.map(Vec::from).collect();
        let count = left.len();
        for k in 0..count {
            let size = |row: &usize| left[*row][k].size();
            let pivot = (k..count).max_by(|a, b| size(a).total_cmp(&size(b)))?;
            left.swap(k, pivot);
            right.swap(k, pivot);
            if left[k][k].size() == 0.0 {
                return None;
            }
            let (pivot, above) = (left[k].clone(), right[k].clone());
            for row in (0..count).filter(|row| *row != k) {
                let factor = left[row][k] / pivot[k];
                let less = |row: &mut Vec<Approximate>, pivot: &[Approximate]| {
                    for (entry, pivot) in row.iter_mut().zip(pivot) {
                        *entry = *entry - factor * *pivot;
                    }
                };
                less(&mut left[row], &pivot);
                less(&mut right[row], &above);
            }
        }
        let rows = right.into_iter().enumerate();
        let rows = rows.map(|(k, row)| row.into_iter().map(|x| x / left[k][k]).collect());
        Some(rows.collect())
    }

    /// M⁻¹, by rows.
    pub(crate) fn inverse_mass_matrix(&self) -> Option<Vec<Vec<Approximate>>> {
        let count = self.state.velocities();
        let unit = |row: usize| (0..count).map(move |k| if k == row { 1.0 } else { 0.0 });
        let rows = (0..count).map(|row| unit(row).map(Approximate::exact).collect());
        self.eliminated(rows.collect())
    }

    /// τ of the state, less that of the motion without q̈.
    pub(crate) fn unbalanced_torques(&self) -> GeneralizedVector {
        let tau = self.state.of_velocities(Variable::Tau).into_iter();
        let pairs = tau.zip(self.coasting_torques());
        pairs.map(|(tau, bias)| tau - bias).collect()
    }

    /// −M⁻¹ Y, by rows, with Y at the accelerations that τ produces.
    pub(crate) fn accelerations_by_parameters(&self) -> Option<Vec<Approximate>> {
        let solver = Solver::of(self)?;
        let accelerations = solver.solution(&self.unbalanced_torques());
        let columns = self.regressor_of(accelerations).into_iter();
        let solutions = columns.map(|column| solver.solution(&opposite(&column)));
        let solutions: Vec<GeneralizedVector> = solutions.collect();
        Some(self.rows_of(&solutions.iter().collect::<Vec<_>>()))
    }

    /// The motion that τ produces, and y = M⁻¹ λ.
    pub(crate) fn with_accelerations(&self) -> Option<Accelerated<'_>> {
        let solver = Solver::of(self)?;
        let accelerations = solver.solution(&self.unbalanced_torques());
        Some(Accelerated {
            dense: self,
            y: solver.solution(&self.state.of_velocities(Variable::Weights)),
            by_motion: self.torque_derivatives_of(accelerations.clone()),
            accelerations,
            solver,
        })
    }
}

/// The motion that τ produces, with what all derivatives of λᵀq̈ are made of.
pub(crate) struct Accelerated<'d> {
    dense: &'d Dense,
    solver: Solver<'d>,
    accelerations: GeneralizedVector,
    /// M⁻¹ λ.
    y: GeneralizedVector,
    /// ∂τ/∂q and ∂τ/∂q̇.
    by_motion: [Square<VelocityId, Approximate>; 2],
}

impl Accelerated<'_> {
    /// The derivatives of λᵀq̈ by q, q̇ and τ.
    pub(crate) fn gradient(&self) -> Vec<Approximate> {
        let by_motion = self.by_motion.iter();
        let by_motion = by_motion.flat_map(|by| opposite(&row_times(&self.y, by)));
        by_motion.chain(self.y.clone()).collect()
    }

    /// q̈, and its change along those of q, q̇ and τ.
    pub(crate) fn change(&self) -> Vec<Approximate> {
        let [by_q, by_qd] = &self.by_motion;
        let of_motion = [(by_q, Variable::QChange), (by_qd, Variable::QdChange)];
        let tau = self.dense.state.of_velocities(Variable::TauChange);
        let forces = difference(&tau, &self.dense.along(&of_motion));
        let change = self.solver.solution(&forces);
        self.accelerations.iter().copied().chain(change).collect()
    }

    /// The second derivatives of λᵀq̈, of the blocks by q and q, q and q̇, q̇ and q̇, q and τ: the sum of the rows of
    /// each, times the entries of a direction.
    pub(crate) fn hessian(&self, direction: &GeneralizedVector) -> Vec<Approximate> {
        let [by_q, by_qd] = &self.by_motion;
        let accelerations = || self.accelerations.clone();
        let of_torques = self
            .dense
            .torque_hessian_of(accelerations(), &self.y, direction);
        let [q_q, q_qd, qd_qd, q_qdd] = of_torques;
        let by_tau = self.solver.solution(&opposite(&q_qdd));
        // A change of q along the direction changes q̈ by −w, and τ of a further q̈ = w is M w.
        let w = self.solver.solution(&times_column(by_q, direction));
        let further = sum(&accelerations(), &w);
        let [with_further, _] = self.dense.torque_derivatives_of(further);
        let of_inertia = difference(
            &row_times(&self.y, &with_further),
            &row_times(&self.y, by_q),
        );
        let parts = [
            difference(&of_inertia, &sum(&q_q, &row_times(&by_tau, by_q))),
            opposite(&sum(&q_qd, &row_times(&by_tau, by_qd))),
            opposite(&qd_qd),
            by_tau,
        ];
        parts.into_iter().flatten().collect()
    }
}

/// M⁻¹, with the mass matrix.
struct Solver<'d> {
    inverse: Square<VelocityId, Approximate>,
    matrix: &'d Square<VelocityId, Approximate>,
}

impl<'d> Solver<'d> {
    fn of(dense: &'d Dense) -> Option<Self> {
        let inverse = dense.inverse_mass_matrix()?.concat();
        let inverse: Vec<Approximate> = inverse.into_iter().map(Approximate::as_found).collect();
        Some(Self {
            inverse: Square::of_rows(&inverse),
            matrix: dense.mass_matrix(),
        })
    }

    /// x of M x = b, with the error that roundings of the described numbers in M and the error of b make in it.
    fn solution(&self, right: &GeneralizedVector) -> GeneralizedVector {
        let exact = right.map(|entry| entry.as_found());
        let found = times_column(&self.inverse, &exact);
        let size = |k: VelocityId| self.matrix[(k, k)].size().sqrt();
        let moved: f64 = found.numbered().map(|(k, x)| size(k) * x.size()).sum();
        let error = |row: VelocityId| -> f64 {
            let shares = right.numbered().map(|(k, right)| {
                self.inverse[(row, k)].size() * (right.error + ROUNDOFF * size(k) * moved)
            });
            shares.sum()
        };
        let entries = found.numbered().map(|(row, x)| Approximate {
            error: error(row),
            ..*x
        });
        entries.collect()
    }
}

fn opposite(a: &GeneralizedVector) -> GeneralizedVector {
    a.map(|&entry| -entry)
}

fn sum(a: &GeneralizedVector, b: &GeneralizedVector) -> GeneralizedVector {
    a.iter().zip(b).map(|(&a, &b)| a + b).collect()
}

fn difference(a: &GeneralizedVector, b: &GeneralizedVector) -> GeneralizedVector {
    a.iter().zip(b).map(|(&a, &b)| a - b).collect()
}
