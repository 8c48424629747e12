//! Products of vectors with derivatives of the dynamics, and the Hessian of λᵀq̈.
//!
//! In: a [`Chain`], a state, and weights λ or a direction. Out: the gradients of λᵀτ and λᵀq̈, and changes along a
//! direction, by matrices of first derivatives; second derivatives of λᵀq̈ from those of yᵀτ with y = M⁻¹ λ, by differentiating τ(q, q̇, q̈(q, q̇, τ)) twice.

use super::super::derivatives::inverse_dynamics_derivatives;
use super::super::hessian::inverse_dynamics_hessian;
use super::dynamics::{inverse_dynamics, mass_matrix};
use super::forward::{forward_dynamics, forward_dynamics_derivatives, mass_matrix_inverse};
use crate::robot::chain::Chain;
use crate::robot::derivatives::{
    AccelerationChange, AccelerationGradient, AccelerationHessian, TorqueChange, TorqueGradient,
};
use core::array::from_fn;
use nalgebra::{RealField, SMatrix};

/// The gradient of λᵀτ by q, q̇ and q̈, where τ are the torques [N m] and forces \[N\] that produce q̈.
#[must_use]
pub fn inverse_dynamics_vjp<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    qdd: &[T; N],
    weights: &[T; N],
) -> TorqueGradient<N, T> {
    let derivatives = inverse_dynamics_derivatives(chain, q, qd, qdd);
    TorqueGradient {
        dq: contracted(&derivatives.dq, weights),
        dqd: contracted(&derivatives.dqd, weights),
        dqdd: contracted(&mass_matrix(chain, q), weights),
    }
}

/// The gradient of λᵀq̈ by q, q̇ and τ, where q̈ are the accelerations [rad/s², m/s²] that τ produces.
///
/// NaN if the mass matrix is not positive definite.
#[must_use]
pub fn forward_dynamics_vjp<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    tau: &[T; N],
    weights: &[T; N],
) -> AccelerationGradient<N, T> {
    let derivatives = forward_dynamics_derivatives(chain, q, qd, tau);
    AccelerationGradient {
        dq: contracted(&derivatives.dq, weights),
        dqd: contracted(&derivatives.dqd, weights),
        dtau: contracted(&derivatives.dtau, weights),
    }
}

/// The torques [N m] and forces \[N\] that produce q̈, and their change along changes of q, q̇ and q̈; that of q is along
/// velocities.
#[must_use]
pub fn inverse_dynamics_jvp<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    qdd: &[T; N],
    q_change: &[T; N],
    qd_change: &[T; N],
    qdd_change: &[T; N],
) -> TorqueChange<N, T> {
    let derivatives = inverse_dynamics_derivatives(chain, q, qd, qdd);
    let matrices = [derivatives.dq, derivatives.dqd, mass_matrix(chain, q)];
    TorqueChange {
        value: inverse_dynamics(chain, q, qd, qdd),
        change: along(&matrices, [q_change, qd_change, qdd_change]),
    }
}

/// The accelerations [rad/s², m/s²] that τ produces, and their change along changes of q, q̇ and τ; that of q is along
/// velocities.
///
/// NaN if the mass matrix is not positive definite.
#[must_use]
pub fn forward_dynamics_jvp<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    tau: &[T; N],
    q_change: &[T; N],
    qd_change: &[T; N],
    tau_change: &[T; N],
) -> AccelerationChange<N, T> {
    let derivatives = forward_dynamics_derivatives(chain, q, qd, tau);
    let matrices = [derivatives.dq, derivatives.dqd, derivatives.dtau];
    AccelerationChange {
        value: forward_dynamics(chain, q, qd, tau),
        change: along(&matrices, [q_change, qd_change, tau_change]),
    }
}

/// Second derivatives of λᵀq̈, where q̈ are the accelerations [rad/s², m/s²] that τ produces.
///
/// NaN if the mass matrix is not positive definite.
#[must_use]
pub fn forward_dynamics_hessian<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    tau: &[T; N],
    weights: &[T; N],
) -> AccelerationHessian<N, T> {
    let qdd = forward_dynamics(chain, q, qd, tau);
    let first = forward_dynamics_derivatives(chain, q, qd, tau);
    let y = contracted(&mass_matrix_inverse(chain, q), weights);
    let of_torques = inverse_dynamics_hessian(chain, q, qd, &qdd, &y);
    let matrix = |rows: [[T; N]; N]| SMatrix::<T, N, N>::from_fn(|i, k| rows[i][k]);
    let rows = |matrix: SMatrix<T, N, N>| from_fn(|i| from_fn(|k| matrix[(i, k)]));
    let [by_q, by_qd, by_tau] = [first.dq, first.dqd, first.dtau].map(matrix);
    let of_inertia = matrix(of_torques.dq_dqdd);
    let turned = of_inertia * by_q;
    AccelerationHessian {
        dq_dq: rows(-(matrix(of_torques.dq_dq) + turned + turned.transpose())),
        dq_dqd: rows(-(matrix(of_torques.dq_dqd) + of_inertia * by_qd)),
        dqd_dqd: rows(-matrix(of_torques.dqd_dqd)),
        dq_dtau: rows(-of_inertia * by_tau),
    }
}

/// λᵀ A.
fn contracted<T: RealField + Copy, const N: usize>(
    matrix: &[[T; N]; N],
    weights: &[T; N],
) -> [T; N] {
    from_fn(|k| {
        let terms = matrix.iter().zip(weights);
        super::sum(terms.map(|(row, &weight)| row[k] * weight))
    })
}

/// Σ A x.
fn along<T: RealField + Copy, const N: usize>(
    matrices: &[[[T; N]; N]; 3],
    directions: [&[T; N]; 3],
) -> [T; N] {
    from_fn(|row| {
        let parts = matrices.iter().zip(directions);
        let terms = parts.flat_map(|(matrix, direction)| {
            let terms = matrix[row].iter().zip(direction);
            terms.map(|(&entry, &change)| entry * change)
        });
        super::sum(terms)
    })
}
