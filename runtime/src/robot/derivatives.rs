//! The results of first and second derivatives of the dynamics: one struct each, with a field for each vector or matrix.

/// Derivatives of inverse dynamics by q and q̇; see [`crate::robot`]. The derivative by q̈ is the mass matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorqueDerivatives<const N: usize, T = f64> {
    /// ∂τ/∂q, a row for each torque or force [N m, N, N/m].
    pub dq: [[T; N]; N],
    /// ∂τ/∂q̇, a row for each torque or force [N m s, N s, N s/m].
    pub dqd: [[T; N]; N],
}

/// Gradient of λᵀτ, for weights λ of the torques of inverse dynamics; see [`crate::robot`].
///
/// Derivatives by q are along velocities. With λ as a virtual displacement [rad or m], λᵀτ is a work \[J\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorqueGradient<const N: usize, T = f64> {
    /// (∂τ/∂q)ᵀ λ [J, J/m].
    pub dq: [T; N],
    /// (∂τ/∂q̇)ᵀ λ [J s, J s/m].
    pub dqd: [T; N],
    /// (∂τ/∂q̈)ᵀ λ = M λ [J s², J s²/m].
    pub dqdd: [T; N],
}

/// Torques of inverse dynamics, and their change along changes of q, q̇ and q̈; see [`crate::robot`].
///
/// Changes of q are along velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorqueChange<const N: usize, T = f64> {
    /// τ [N m, N].
    pub value: [T; N],
    /// δτ = (∂τ/∂q) δq + (∂τ/∂q̇) δq̇ + M δq̈ [N m, N].
    pub change: [T; N],
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

/// Gradient of λᵀq̈, for weights λ of the accelerations of forward dynamics; see [`crate::robot`].
///
/// Derivatives by q are along velocities. With λ as torques and forces [N m or N], λᵀq̈ is a power by time [W/s].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationGradient<const N: usize, T = f64> {
    /// (∂q̈/∂q)ᵀ λ [W/s, W/(s m)].
    pub dq: [T; N],
    /// (∂q̈/∂q̇)ᵀ λ [W, W/m].
    pub dqd: [T; N],
    /// (∂q̈/∂τ)ᵀ λ = M⁻¹ λ [rad/s², m/s²].
    pub dtau: [T; N],
}

/// Accelerations of forward dynamics, and their change along changes of q, q̇ and τ; see [`crate::robot`].
///
/// Changes of q are along velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationChange<const N: usize, T = f64> {
    /// q̈ [rad/s², m/s²].
    pub value: [T; N],
    /// δq̈ = (∂q̈/∂q) δq + (∂q̈/∂q̇) δq̇ + M⁻¹ δτ [rad/s², m/s²].
    pub change: [T; N],
}

/// Second derivatives of λᵀq̈, for weights λ of the accelerations of forward dynamics; see [`crate::robot`].
///
/// An entry is the derivative, by the coordinate or velocity of its row, of the derivative by that of its column.
/// Derivatives by q are along velocities; those of two velocities of one joint do not commute. With λ as torques and
/// forces [N m or N], λᵀq̈ is a power by time [W/s]. Blocks that are not listed are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AccelerationHessian<const N: usize, T = f64> {
    /// ∂²(λᵀq̈)/∂q∂q [W/s, W/(s m), W/(s m²)].
    pub dq_dq: [[T; N]; N],
    /// ∂²(λᵀq̈)/∂q∂q̇, a row for each coordinate [W, W/m, W/m²].
    pub dq_dqd: [[T; N]; N],
    /// ∂²(λᵀq̈)/∂q̇∂q̇, symmetric [W s, W s/m, W s/m²].
    pub dqd_dqd: [[T; N]; N],
    /// ∂²(λᵀq̈)/∂q∂τ = ∂(M⁻¹ λ)/∂q, a row for each coordinate [1/s², 1/(s² m), m/s²].
    pub dq_dtau: [[T; N]; N],
}
