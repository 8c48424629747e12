//! Derivatives of torques, multiplied by vectors: gradients of λᵀτ, and changes along a direction.

use super::{Approximate, Dense, MotionOrder};
use crate::list::{List, Square};
use crate::space::{Variable, VelocityId};

/// A vector with an entry for each velocity: accelerations, torques or weights.
pub(super) type GeneralizedVector = List<VelocityId, Approximate>;

impl Dense {
    /// (∂τ/∂q)ᵀ λ, (∂τ/∂q̇)ᵀ λ and M λ, of the whole motion with the external wrenches.
    pub(crate) fn torque_gradient(&self) -> Vec<Approximate> {
        let weights = self.state.of_velocities(Variable::Weights);
        let [by_q, by_qd] = self.torque_derivatives();
        let parts = [&by_q, &by_qd, self.mass_matrix()];
        let parts = parts.map(|matrix| row_times(&weights, matrix));
        parts.into_iter().flatten().collect()
    }

    /// τ of the whole motion with the external wrenches, and its change along those of q, q̇ and q̈.
    pub(crate) fn torque_change(&self) -> Vec<Approximate> {
        let [by_q, by_qd] = self.torque_derivatives();
        let change = self.along(&[
            (&by_q, Variable::QChange),
            (&by_qd, Variable::QdChange),
            (self.mass_matrix(), Variable::QddChange),
        ]);
        let torques = self.less_external(self.torques(MotionOrder::Accelerated));
        torques.into_iter().chain(change).collect()
    }

    /// The sum of products of matrices with arguments.
    pub(super) fn along(
        &self,
        parts: &[(&Square<VelocityId, Approximate>, Variable)],
    ) -> GeneralizedVector {
        let nothing = List::filled(Approximate::exact(0.0), self.state.velocities());
        parts
            .iter()
            .fold(nothing, |sum: GeneralizedVector, &(matrix, of)| {
                let part = times_column(matrix, &self.state.of_velocities(of));
                sum.iter()
                    .zip(part)
                    .map(|(&sum, part)| sum + part)
                    .collect()
            })
    }
}

/// The product xᵗ A.
pub(crate) fn row_times(
    x: &GeneralizedVector,
    a: &Square<VelocityId, Approximate>,
) -> GeneralizedVector {
    let column = |column: VelocityId| dot(x.iter().copied().zip(a.column(column)));
    a.ids().map(column).collect()
}

/// The product A x.
pub(super) fn times_column(
    a: &Square<VelocityId, Approximate>,
    x: &GeneralizedVector,
) -> GeneralizedVector {
    let row = |row: VelocityId| dot(x.iter().copied().zip(a.row(row)));
    a.ids().map(row).collect()
}

fn dot(pairs: impl Iterator<Item = (Approximate, Approximate)>) -> Approximate {
    pairs.fold(Approximate::exact(0.0), |sum, (a, b)| sum + a * b)
}
