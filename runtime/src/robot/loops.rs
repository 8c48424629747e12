//! One small trait for each function of the loops of a robot.
//!
//! In: joint coordinates `q`, their rates `qd` and forces `tau`. Out: arrays of `C` numbers, one for each
//! residual. A residual is zero where its loop is closed; the doc comments of generated code list them in
//! order. Robots that are generated with loops implement these traits. `N` is the number of degrees of
//! freedom of the open tree, `Q` the number of coordinates.

use super::constrained;

/// The residuals of the loops.
#[diagnostic::on_unimplemented(
    message = "the robot `{Self}` lacks a function that is needed here",
    label = "needs a robot with closed loops and this function",
    note = "describe its loops and add `constraint` to `generate(…)` of the robot"
)]
pub trait Constraint<const N: usize, const C: usize, T = f64, const Q: usize = N> {
    /// For the frames A and B of each loop: distances along the axes of A \[m\], and products of an axis of A
    /// with an axis of B. Zero where the loops are closed.
    #[must_use]
    fn constraint(&self, q: &[T; Q]) -> [T; C];
}

/// The Jacobian of the residuals of the loops.
#[diagnostic::on_unimplemented(
    message = "the robot `{Self}` lacks a function that is needed here",
    label = "needs a robot with closed loops and this function",
    note = "describe its loops and add `constraint_jacobian` to `generate(…)` of the robot"
)]
pub trait ConstraintJacobian<const N: usize, const C: usize, T = f64, const Q: usize = N> {
    /// J, a row for each residual; the rate of the residuals is J q̇.
    #[must_use]
    fn constraint_jacobian(&self, q: &[T; Q]) -> [[T; N]; C];
}

/// The second derivatives in time of the residuals of the loops at q̈ = 0.
#[diagnostic::on_unimplemented(
    message = "the robot `{Self}` lacks a function that is needed here",
    label = "needs a robot with closed loops and this function",
    note = "describe its loops and add `constraint_bias` to `generate(…)` of the robot"
)]
pub trait ConstraintBias<const N: usize, const C: usize, T = f64, const Q: usize = N> {
    /// γ = J̇ q̇ [m/s², 1/s²]: the second rate of a residual is J q̈ + γ.
    #[must_use]
    fn constraint_bias(&self, q: &[T; Q], qd: &[T; N]) -> [T; C];
}

/// The joint accelerations due to torques and forces with closed loops, and the constraint forces.
#[diagnostic::on_unimplemented(
    message = "the robot `{Self}` lacks a function that is needed here",
    label = "needs a robot with closed loops and this function",
    note = "describe its loops and add `constrained_forward_dynamics` to `generate(…)` of the robot"
)]
pub trait ConstrainedForwardDynamics<const N: usize, const C: usize, T = f64, const Q: usize = N> {
    /// q̈ and λ of M q̈ + bias = τ + Jᵗ λ and J q̈ + γ = 0. λ is zero for a residual that depends on those before
    /// it.
    #[must_use]
    fn constrained_forward_dynamics(
        &self,
        q: &[T; Q],
        qd: &[T; N],
        tau: &[T; N],
    ) -> constrained::ConstrainedAccelerations<N, C, T>;
}

/// The torques and forces of the actuated joints of a robot with closed loops.
#[diagnostic::on_unimplemented(
    message = "the robot `{Self}` lacks a function that is needed here",
    label = "needs a robot with closed loops and this function",
    note = "describe its loops and add `actuated_inverse_dynamics` to `generate(…)` of the robot"
)]
pub trait ActuatedInverseDynamics<const N: usize, T = f64, const Q: usize = N> {
    /// τ that produces q̈ under gravity [N m, N], zero for joints without actuator; q, q̇ and q̈ must keep the
    /// loops closed.
    #[must_use]
    fn actuated_inverse_dynamics(&self, q: &[T; Q], qd: &[T; N], qdd: &[T; N]) -> [T; N];
}
