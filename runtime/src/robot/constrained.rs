//! How joints move where loops hold them together, and what holds them.
//!
//! In: accelerations and multipliers. Out: the same by name. It computes nothing.

/// The joint accelerations of given torques and forces where the loops of a robot are held together, and
/// what holds them; see [`crate::robot`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstrainedAccelerations<const N: usize, const C: usize, T = f64> {
    /// q̈ of M q̈ + bias = τ + Jᵗ λ and J q̈ + γ = 0 [rad/s², m/s²].
    pub qdd: [T; N],
    /// λ, one for each residual: forces on frame B along the axes of A \[N\], for products of axes torques
    /// \[N m\], along a rod its force, positive where it pushes.
    pub multipliers: [T; C],
}
