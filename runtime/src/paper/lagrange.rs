//! Lagrange's formulation of the dynamics of a chain, by traces of 4×4 matrices.
//!
//! In: a [`Chain`], its state and external wrenches. Out: derivatives of M and J with respect to the
//! coordinates, the mass matrix, the bias and the torques (Part II, Lagrange). The results are those of
//! Newton–Euler in [`crate::open_chain`], by independent code.

use super::open_chain::{bias_accelerations, inertias, poses, screws, sums_over_carried};
use crate::matrix::{Acceleration, Action, Inertia, Pose, Screw};
use crate::robot::chain::Chain;
use crate::scalar::Scalar;
use core::array::from_fn;

/// ∂M/∂qₘ = Lₘ M, the derivative of a pose that joint m moves, as rows of the 4×4 matrix
/// (Part II, Lagrange).
///
/// `l` is Lₘ in the frame in which `pose` is given.
#[must_use]
pub fn pose_derivative<T: Scalar>(l: &Screw<T>, pose: &Pose<T>) -> [[T; 4]; 4] {
    product(&l.to_matrix(), &pose.to_matrix())
}

/// ∂J/∂qₘ = Lₘ J + J Lₘᵗ, the derivative of the inertia of a body that joint m moves, in a frame
/// that does not move with it (Part II, Lagrange). The derivative of the mass is zero.
#[must_use]
pub fn inertia_derivative<T: Scalar>(l: &Screw<T>, inertia: &Inertia<T>) -> Inertia<T> {
    let x = product(&l.to_matrix(), &inertia.to_matrix());
    let entry = |i: usize, j: usize| x[i][j] + x[j][i];
    Inertia::new(
        [
            entry(0, 0),
            entry(1, 1),
            entry(2, 2),
            entry(0, 1),
            entry(0, 2),
            entry(1, 2),
        ],
        from_fn(|i| entry(i, 3)),
        T::constant(0.0),
    )
}

/// The mass matrix M\[i\]\[m\] = Tr(Σ Lᵢ Jₕ Lₘᵗ), the sum over the bodies h that both joints carry
/// (in an unbranched chain h ≥ max(i, m)); symmetric, as rows (Part II, Lagrange).
#[must_use]
pub fn mass_matrix<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
) -> [[T; N]; N] {
    let poses = poses(chain, q);
    let screws = screws(chain, &poses);
    let carried = sums_over_carried(chain, inertias(chain, &poses), |sum, j| sum + j);
    from_fn(|i| {
        from_fn(|m| {
            let (inner, outer) = (i.min(m), i.max(m));
            if chain.carries(inner, Some(outer)) {
                // The same order on both sides of the diagonal, so that M is exactly symmetric.
                trace(&screws[inner], &carried[outer], &screws[outer])
            } else {
                T::constant(0.0)
            }
        })
    })
}

/// The bias C\[m\] = Tr(Σ (H̃ₕ − H_g) Jₕ Lₘᵗ) − Lₘ ⊗ Σ Φₕ, the sums over the bodies h that joint m
/// carries [N m, N] (Part II, Lagrange).
///
/// `external` holds the wrenches Φₕ on the bodies besides their weight, in frame 0 [N m, N].
#[must_use]
pub fn bias<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
    external: &[Action<T>; N],
) -> [T; N] {
    let poses = poses(chain, q);
    let (screws, inertias) = (screws(chain, &poses), inertias(chain, &poses));
    let gravity = chain.gravity.map(T::constant);
    let h = bias_accelerations(chain, q, qd).map(|h: Acceleration<T>| h.less_gravity(gravity));
    let forces: [[[T; 4]; 4]; N] =
        from_fn(|i| product(&h[i].to_matrix(), &inertias[i].to_matrix()));
    let forces = sums_over_carried(chain, forces, |x, y| sum(&x, &y));
    let actions = sums_over_carried(chain, *external, |sum, action| sum + action);
    from_fn(|m| {
        trace_with_transpose(&forces[m], &screws[m].to_matrix())
            - screws[m].pseudo_scalar_product(&actions[m])
    })
}

/// τ = M q̈ + C, the torques [N m] and forces \[N\] of the joints (Part II, Lagrange).
#[must_use]
pub fn inverse_dynamics<T: Scalar, const N: usize, const F: usize>(
    chain: &Chain<N, F>,
    q: &[T; N],
    qd: &[T; N],
    qdd: &[T; N],
    external: &[Action<T>; N],
) -> [T; N] {
    let (mass, bias) = (mass_matrix(chain, q), bias(chain, q, qd, external));
    from_fn(|i| {
        let row = mass[i].iter().zip(qdd);
        row.fold(bias[i], |torque, (m, qdd)| torque + *m * *qdd)
    })
}

/// Tr(A J Bᵗ) for screws A and B, all in one frame; [`Inertia::coupling`] is the same by vectors.
fn trace<T: Scalar>(a: &Screw<T>, inertia: &Inertia<T>, b: &Screw<T>) -> T {
    let x = product(&a.to_matrix(), &inertia.to_matrix());
    trace_with_transpose(&x, &b.to_matrix())
}

/// X Y.
fn product<T: Scalar>(x: &[[T; 4]; 4], y: &[[T; 4]; 4]) -> [[T; 4]; 4] {
    x.map(|[a, b, c, d]| from_fn(|j| a * y[0][j] + b * y[1][j] + c * y[2][j] + d * y[3][j]))
}

/// X + Y.
fn sum<T: Scalar>(x: &[[T; 4]; 4], y: &[[T; 4]; 4]) -> [[T; 4]; 4] {
    from_fn(|i| from_fn(|j| x[i][j] + y[i][j]))
}

/// Tr(X Yᵗ).
fn trace_with_transpose<T: Scalar>(x: &[[T; 4]; 4], y: &[[T; 4]; 4]) -> T {
    let entries = x.as_flattened().iter().zip(y.as_flattened());
    entries.fold(T::constant(0.0), |sum, (x, y)| sum + *x * *y)
}
