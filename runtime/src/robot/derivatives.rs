//! The results of first and second derivatives of the dynamics: one struct each, with a field for each matrix.

/// Derivatives of inverse dynamics by q and q̇; see [`crate::robot`]. The derivative by q̈ is the mass matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorqueDerivatives<const N: usize, T = f64> {
    /// ∂τ/∂q, a row for each torque or force [N m, N, N/m].
    pub dq: [[T; N]; N],
    /// ∂τ/∂q̇, a row for each torque or force [N m s, N s, N s/m].
    pub dqd: [[T; N]; N],
}

/// Second derivatives of λᵀτ, for weights λ of the torques of inverse dynamics; see [`crate::robot`].
///
/// An entry is the derivative, by the coordinate or velocity of its row, of the derivative by that of its column.
/// Derivatives by q are along velocities; those of two velocities of one joint do not commute. With λ as a virtual
/// displacement [rad or m], λᵀτ is a work \[J\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorqueHessian<const N: usize, T = f64> {
    /// ∂²(λᵀτ)/∂q∂q [J, J/m, J/m²].
    pub dq_dq: [[T; N]; N],
    /// ∂²(λᵀτ)/∂q∂q̇, a row for each coordinate [J s, J s/m, J s/m²].
    pub dq_dqd: [[T; N]; N],
    /// ∂²(λᵀτ)/∂q̇∂q̇, symmetric [J s², J s²/m, J s²/m²].
    pub dqd_dqd: [[T; N]; N],
    /// ∂²(λᵀτ)/∂q∂q̈ = ∂(M λ)/∂q, a row for each coordinate [J s², J s²/m, J s²/m²].
    pub dq_dqdd: [[T; N]; N],
}

/// Derivatives of forward dynamics by q, q̇ and τ; see [`crate::robot`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationDerivatives<const N: usize, T = f64> {
    /// ∂q̈/∂q, a row for each acceleration [1/s², 1/(m s²), m/s²].
    pub dq: [[T; N]; N],
    /// ∂q̈/∂q̇, a row for each acceleration [1/s, 1/(m s), m/s].
    pub dqd: [[T; N]; N],
    /// ∂q̈/∂τ, the inverse of the mass matrix [1/(kg m²), 1/(kg m), 1/kg].
    pub dtau: [[T; N]; N],
}
