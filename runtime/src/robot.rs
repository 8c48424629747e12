//! One small trait for each function of a robot.
//!
//! In: joint coordinates `q`, velocities `qd` and accelerations `qdd` (rad or m, and seconds). Out:
//! arrays and typed matrices. Generated robots and [`crate::Chain`] implement these traits, so that
//! a controller can be written for any robot that has the functions it needs.
//!
//! `N` is the number of velocities, and `Q` of coordinates: the same where every joint has one, and
//! then need not be written. What they are of each kind of joint is said by [`Motion`](crate::Motion).
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
pub(crate) mod joint;
pub mod posture;
mod step;

/// Calls a macro with every function: what it is; what it returns, in which units; whether it is of the
/// tip, of the whole robot or a solution for it; its trait and its method with the arguments and the
/// result.
///
/// Not for users: it is the list from which traits, their implementations and tests are made.
#[doc(hidden)]
#[macro_export]
macro_rules! every_function {
    ($then:ident) => {
        $then! {
            /// The pose of the tip.
            /// M₀,tip.
            tip ForwardKinematics forward_kinematics(q) -> $crate::Pose<T>;
            /// The Jacobian in frame 0.
            /// L₁ … L_N, in frame 0, pole at its origin.
            tip SpatialJacobian spatial_jacobian(q) -> [$crate::Screw<T>; N];
            /// The Jacobian in the frame of the tip.
            /// L₁ … L_N, in the frame of the tip, pole at its origin.
            tip BodyJacobian body_jacobian(q) -> [$crate::Screw<T>; N];
            /// The Jacobian with the axes of frame 0 and the tip as pole.
            /// L₁ … L_N, with the axes of frame 0, pole at the origin of the tip.
            tip GeometricJacobian geometric_jacobian(q) -> [$crate::Screw<T>; N];
            /// The velocity of the tip.
            /// W₀,tip₍₀₎, in rad/s and m/s.
            tip Velocity velocity(q, qd) -> $crate::Velocity<T>;
            /// The acceleration of the tip.
            /// H₀,tip₍₀₎, without gravity.
            tip Acceleration acceleration(q, qd, qdd) -> $crate::Acceleration<T>;
            /// The joint torques and forces of a motion.
            /// The torques [N m] and forces \[N\] of the joints that produce q̈ under gravity.
            whole InverseDynamics inverse_dynamics(q, qd, qdd) -> [T; N];
            /// The joint torques and forces at rest.
            /// Inverse dynamics at rest: what holds the robot against gravity [N m, N].
            whole Gravity gravity(q) -> [T; N];
            /// The joint torques and forces at q̈ = 0.
            /// Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms [N m, N].
            whole Bias bias(q, qd) -> [T; N];
            /// The joint-space inertia matrix.
            /// M(q) of τ = M q̈ + bias: symmetric, as rows.
            whole MassMatrix mass_matrix(q) -> [[T; N]; N];
            /// The joint accelerations of given torques and forces.
            /// The accelerations [rad/s², m/s²] that torques \[N m\] and forces \[N\] of the joints produce
            /// under gravity.
            solution ForwardDynamics forward_dynamics(q, qd, tau) -> [T; N];
            /// The inverse of the joint-space inertia matrix.
            /// M(q)⁻¹: symmetric, as rows.
            solution MassMatrixInverse mass_matrix_inverse(q) -> [[T; N]; N];
            /// The kinetic energy.
            /// ½ Σ Tr(W J Wᵗ) \[J\].
            whole KineticEnergy kinetic_energy(q, qd) -> T;
            /// The potential energy.
            /// −Σ Tr(H_g J) of what the joints move \[J\], zero at the origin of frame 0.
            whole PotentialEnergy potential_energy(q) -> T;
        }
    };
}

/// What an argument lists: `q` an entry for each coordinate, all others one for each velocity.
macro_rules! list_of {
    (q) => {
        [T; Q]
    };
    ($other:ident) => {
        [T; N]
    };
}
pub(crate) use list_of;

macro_rules! traits {
    ($(
        #[doc = $noun:literal]
        $(#[doc = $sentence:literal])+
        $kind:ident $name:ident $method:ident($($argument:ident),*) -> $result:ty;
    )*) => {$(
        #[doc = $noun]
        pub trait $name<const N: usize, T = f64, const Q: usize = N> {
            $(#[doc = $sentence])+
            #[must_use]
            fn $method(&self, $($argument: &$crate::robot::list_of!($argument)),*) -> $result;
        }
    )*};
}
every_function!(traits);
