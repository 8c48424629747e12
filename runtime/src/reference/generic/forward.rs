//! Forward dynamics, the inverse of the mass matrix, and derivatives of the accelerations, at run time.
//!
//! In: a [`Chain`], its positions and velocities, and torques. Out: accelerations, M⁻¹ and derivatives, all by the
//! Cholesky factors of M; NaN if M is not positive definite.

use super::dynamics::{bias, mass_matrix, regressor};
use crate::reference::derivatives::inverse_dynamics_derivatives;
use crate::robot::chain::Chain;
use crate::robot::derivatives::AccelerationDerivatives;
use core::array::from_fn;
use nalgebra::{Cholesky, Const, RealField, SMatrix, SVector};

/// The joint accelerations [rad/s², m/s²] that the torques \[N m\] and forces \[N\] `tau` produce:
/// M q̈ = τ − bias, solved by Cholesky.
///
/// NaN if M is not positive definite.
#[must_use]
pub fn forward_dynamics<
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
) -> [T; N] {
    let bias = bias(chain, q, qd);
    let net_torque: SVector<T, N> = SVector::from_fn(|i, _| tau[i] - bias[i]);
    let found = mass_matrix_factors(chain, q).map(|factors| factors.solve(&net_torque));
    from_fn(|i| found.map_or(nan(), |found| found[i]))
}

/// The inverse of the joint-space inertia matrix, by Cholesky.
///
/// NaN if M is not positive definite.
#[must_use]
pub fn mass_matrix_inverse<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> [[T; N]; N] {
    let found = mass_matrix_factors(chain, q).map(|factors| factors.inverse());
    from_fn(|i| from_fn(|m| found.map_or(nan(), |found| found[(i, m)])))
}

/// ∂q̈/∂q, ∂q̈/∂q̇ and ∂q̈/∂τ of the accelerations that the torques \[N m\] and forces \[N\] `tau` produce:
/// ∂q̈ = M⁻¹ (∂τ − ∂ID), with ∂ID the derivatives of inverse dynamics at constant q̈, by Cholesky.
///
/// NaN if M is not positive definite.
#[must_use]
pub fn forward_dynamics_derivatives<
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
) -> AccelerationDerivatives<N, T> {
    let qdd = forward_dynamics(chain, q, qd, tau);
    let needed = inverse_dynamics_derivatives(chain, q, qd, &qdd);
    let factors = mass_matrix_factors(chain, q);
    let answer = |needed: [[T; N]; N]| {
        let needed: SMatrix<T, N, N> = SMatrix::from_fn(|i, m| -needed[i][m]);
        let found = factors.as_ref().map(|factors| factors.solve(&needed));
        from_fn(|i| from_fn(|m| found.map_or(nan(), |found| found[(i, m)])))
    };
    AccelerationDerivatives {
        dq: answer(needed.dq),
        dqd: answer(needed.dqd),
        dtau: mass_matrix_inverse(chain, q),
    }
}

/// ∂q̈/∂π = −M⁻¹ Y of the accelerations that the torques \[N m\] and forces \[N\] `tau` produce, with the regressor Y
/// of [`regressor`] at these accelerations and its parameters π, a row for each acceleration; by Cholesky.
///
/// NaN if M is not positive definite.
///
/// # Panics
///
/// If `P` is neither 10 B nor 10 B plus three for each velocity of a joint.
#[must_use]
pub fn forward_dynamics_parameter_derivatives<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const P: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
    qd: &[T; N],
    tau: &[T; N],
) -> [[T; P]; N] {
    let qdd = forward_dynamics(chain, q, qd, tau);
    let rows: [[T; P]; N] = regressor(chain, q, qd, &qdd);
    let needed: SMatrix<T, N, P> = SMatrix::from_fn(|i, parameter| -rows[i][parameter]);
    let found = mass_matrix_factors(chain, q).map(|factors| factors.solve(&needed));
    from_fn(|i| from_fn(|parameter| found.map_or(nan(), |found| found[(i, parameter)])))
}

/// The Cholesky factors of M; `None` if it is not positive definite.
fn mass_matrix_factors<
    T: RealField + Copy,
    const N: usize,
    const F: usize,
    const Q: usize,
    const B: usize,
>(
    chain: &Chain<N, F, Q, B>,
    q: &[T; Q],
) -> Option<Cholesky<T, Const<N>>> {
    let rows = mass_matrix(chain, q);
    SMatrix::<T, N, N>::from_fn(|i, m| rows[i][m]).cholesky()
}

fn nan<T: RealField>() -> T {
    nalgebra::convert(f64::NAN)
}
