//! One small trait for each function of the loops of a robot.
//!
//! In: joint coordinates `q`, their rates `qd` and forces `tau`. Out: arrays of `C` numbers, one for each
//! residual: a number that is zero where a loop is closed, in the order of the doc comments of generated
//! code. Robots that are generated with loops implement these traits; N is the number of velocities, Q that
//! of coordinates.

use super::constrained;

/// The residuals of the loops.
pub trait Constraint<const N: usize, const C: usize, T = f64, const Q: usize = N> {
    /// Of frames A and B that each loop holds together, lengths along the axes of A \[m\] and products of an
    /// axis of A with one of B; zero where the loops are closed.
    #[must_use]
    fn constraint(&self, q: &[T; Q]) -> [T; C];
}

/// What velocities change the residuals of the loops by.
pub trait ConstraintJacobian<const N: usize, const C: usize, T = f64, const Q: usize = N> {
    /// J, a row for each residual: its rate is J q̇.
    #[must_use]
    fn constraint_jacobian(&self, q: &[T; Q]) -> [[T; N]; C];
}

/// The accelerations of the residuals of the loops where no velocity changes.
pub trait ConstraintBias<const N: usize, const C: usize, T = f64, const Q: usize = N> {
    /// γ = J̇ q̇ [m/s², 1/s²]: the second rate of a residual is J q̈ + γ.
    #[must_use]
    fn constraint_bias(&self, q: &[T; Q], qd: &[T; N]) -> [T; C];
}

/// The joint accelerations of given torques and forces where the loops are held together, and what holds them.
pub trait ConstrainedForwardDynamics<const N: usize, const C: usize, T = f64, const Q: usize = N> {
    /// q̈ and λ of M q̈ + bias = τ + Jᵗ λ and J q̈ + γ = 0; of a residual that depends on those before it λ is
    /// zero.
    #[must_use]
    fn constrained_forward_dynamics(
        &self,
        q: &[T; Q],
        qd: &[T; N],
        tau: &[T; N],
    ) -> constrained::ConstrainedAccelerations<N, C, T>;
}

/// The torques and forces of the joints that are driven, where loops move the others.
pub trait ActuatedInverseDynamics<const N: usize, T = f64, const Q: usize = N> {
    /// τ, zero for joints that are not driven, which produces q̈ under gravity [N m, N], where q, q̇ and q̈
    /// keep the loops closed.
    #[must_use]
    fn actuated_inverse_dynamics(&self, q: &[T; Q], qd: &[T; N], qdd: &[T; N]) -> [T; N];
}
