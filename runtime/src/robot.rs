//! One small trait for each function of a robot.
//!
//! In: joint coordinates `q`, their rates `qd` and second rates `qdd` (rad or m, and seconds). Out:
//! arrays and typed matrices. Generated robots and [`crate::Chain`] implement these traits, so that
//! a controller can be written for any robot that has the functions it needs.
//!
//! ```
//! use homogen::robot::{Gravity, InverseDynamics};
//!
//! /// Torques that hold a robot still.
//! fn hold<R: Gravity<N>, const N: usize>(robot: &R, q: &[f64; N]) -> [f64; N] {
//!     robot.gravity(q)
//! }
//! ```

// What a robot is as data, and what can be done with the arrays that come back, belong to this room;
// how a function is computed does not.
pub(crate) mod chain;
#[cfg(any(feature = "std", feature = "libm"))]
mod check;
pub(crate) mod jacobian;

use crate::matrix::{Acceleration as AccelerationMatrix, Pose, Screw, Velocity as VelocityMatrix};

/// The pose of the tip.
pub trait ForwardKinematics<const N: usize, T = f64> {
    /// M₀,tip.
    #[must_use]
    fn forward_kinematics(&self, q: &[T; N]) -> Pose<T>;
}

/// The Jacobian in frame 0.
pub trait SpatialJacobian<const N: usize, T = f64> {
    /// L₁ … L_N, in frame 0, pole at its origin.
    #[must_use]
    fn spatial_jacobian(&self, q: &[T; N]) -> [Screw<T>; N];
}

/// The Jacobian in the frame of the tip.
pub trait BodyJacobian<const N: usize, T = f64> {
    /// L₁ … L_N, in the frame of the tip, pole at its origin.
    #[must_use]
    fn body_jacobian(&self, q: &[T; N]) -> [Screw<T>; N];
}

/// The Jacobian with the axes of frame 0 and the tip as pole.
pub trait GeometricJacobian<const N: usize, T = f64> {
    /// L₁ … L_N, with the axes of frame 0, pole at the origin of the tip.
    #[must_use]
    fn geometric_jacobian(&self, q: &[T; N]) -> [Screw<T>; N];
}

/// The velocity of the tip.
pub trait Velocity<const N: usize, T = f64> {
    /// W₀,tip₍₀₎, in rad/s and m/s.
    #[must_use]
    fn velocity(&self, q: &[T; N], qd: &[T; N]) -> VelocityMatrix<T>;
}

/// The acceleration of the tip.
pub trait Acceleration<const N: usize, T = f64> {
    /// H₀,tip₍₀₎, without gravity.
    #[must_use]
    fn acceleration(&self, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> AccelerationMatrix<T>;
}

/// The joint torques and forces of a motion.
pub trait InverseDynamics<const N: usize, T = f64> {
    /// The torques [N m] and forces \[N\] of the joints that produce q̈ under gravity.
    #[must_use]
    fn inverse_dynamics(&self, q: &[T; N], qd: &[T; N], qdd: &[T; N]) -> [T; N];
}

/// The joint torques and forces at rest.
pub trait Gravity<const N: usize, T = f64> {
    /// Inverse dynamics at rest: what holds the robot against gravity [N m, N].
    #[must_use]
    fn gravity(&self, q: &[T; N]) -> [T; N];
}

/// The joint torques and forces at q̈ = 0.
pub trait Bias<const N: usize, T = f64> {
    /// Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms [N m, N].
    #[must_use]
    fn bias(&self, q: &[T; N], qd: &[T; N]) -> [T; N];
}

/// The joint-space inertia matrix.
pub trait MassMatrix<const N: usize, T = f64> {
    /// M(q) of τ = M q̈ + bias: symmetric, as rows.
    #[must_use]
    fn mass_matrix(&self, q: &[T; N]) -> [[T; N]; N];
}

/// The joint accelerations of given torques and forces.
pub trait ForwardDynamics<const N: usize, T = f64> {
    /// The accelerations [rad/s², m/s²] that the torques \[N m\] and forces \[N\] `tau` of the joints
    /// produce under gravity.
    #[must_use]
    fn forward_dynamics(&self, q: &[T; N], qd: &[T; N], tau: &[T; N]) -> [T; N];
}

/// The inverse of the joint-space inertia matrix.
pub trait MassMatrixInverse<const N: usize, T = f64> {
    /// M(q)⁻¹: symmetric, as rows.
    #[must_use]
    fn mass_matrix_inverse(&self, q: &[T; N]) -> [[T; N]; N];
}
