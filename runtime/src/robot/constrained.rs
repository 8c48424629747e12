//! The result of constrained forward dynamics: joint accelerations and constraint forces, by name.

/// Joint accelerations due to torques and forces with closed loops, and the constraint forces; see
/// [`crate::robot`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstrainedAccelerations<const N: usize, const C: usize, T = f64> {
    /// q̈ of M q̈ + bias = τ + Jᵗ λ and J q̈ + γ = 0 [rad/s², m/s²].
    pub qdd: [T; N],
    /// λ, one for each residual: a force on frame B along an axis of A \[N\]; a torque for a product of axes
    /// \[N m\]; for a distance the force along the rod \[N\], positive in compression.
    pub multipliers: [T; C],
}
