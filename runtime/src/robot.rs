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
pub(crate) mod constrained;
pub(crate) mod derivatives;
pub(crate) mod described;
pub(crate) mod drive;
pub(crate) mod jacobian;
pub(crate) mod joint;
mod loops;
pub(crate) mod mechanism;
pub(crate) mod payload;
pub mod posture;
mod step;

pub use loops::{
    ActuatedInverseDynamics, ConstrainedForwardDynamics, Constraint, ConstraintBias,
    ConstraintJacobian,
};

/// Calls a macro with every function: what it is; what it returns, in which units; whether it is of the
/// tip, of the whole robot or a solution for it, or of the whole with `P` numbers in a row of its result, which a chain
/// tells (`sized`) or not (`chosen`); its trait and its method with the arguments and the result.
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
            /// The rate of the Jacobian in frame 0.
            /// L̇₁ … L̇_N of its columns [1/s, m/s].
            tip SpatialJacobianRate spatial_jacobian_rate(q, qd) -> [$crate::Screw<T>; N];
            /// The rate of the Jacobian in the frame of the tip.
            /// L̇₁ … L̇_N of its columns, entry by entry in the moving axes of the tip [1/s, m/s].
            tip BodyJacobianRate body_jacobian_rate(q, qd) -> [$crate::Screw<T>; N];
            /// The rate of the Jacobian with the axes of frame 0 and the tip as pole.
            /// L̇₁ … L̇_N of its columns, whose pole moves with the tip [1/s, m/s].
            tip GeometricJacobianRate geometric_jacobian_rate(q, qd) -> [$crate::Screw<T>; N];
            /// The velocity of the tip.
            /// W₀,tip₍₀₎, in rad/s and m/s.
            tip Velocity velocity(q, qd) -> $crate::Velocity<T>;
            /// The acceleration of the tip.
            /// H₀,tip₍₀₎, without gravity.
            tip Acceleration acceleration(q, qd, qdd) -> $crate::Acceleration<T>;
            /// The acceleration of the tip at q̈ = 0.
            /// H₀,tip₍₀₎ of the velocities alone, without gravity.
            tip AccelerationBias acceleration_bias(q, qd) -> $crate::Acceleration<T>;
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
            /// What the joint torques and forces are for the inertial parameters.
            /// Y of τ = Y π, by rows; π lists for each link m, q_x, q_y, q_z, J_xx, J_xy, J_xz, J_yy, J_yz, J_zz in
            /// its own frame [kg, kg m, kg m²].
            sized Regressor regressor(q, qd, qdd) -> [[T; P]; N];
            /// What the joint torques and forces are for the base parameters.
            /// Y of τ = Y π, by rows, where π are the base parameters: all that torques can tell of the inertial
            /// parameters.
            chosen BaseRegressor base_regressor(q, qd, qdd) -> [[T; P]; N];
            /// The centre of mass.
            /// That of what the joints move, in frame 0 \[m\].
            whole CenterOfMass center_of_mass(q) -> $crate::Point<T>;
            /// The velocity of the centre of mass.
            /// That of what the joints move, in the axes of frame 0 [m/s].
            whole CenterOfMassVelocity center_of_mass_velocity(q, qd) -> [T; 3];
            /// What each joint adds to the velocity of the centre of mass.
            /// The velocity of the centre of mass at a unit rate of each joint, in the axes of frame 0.
            whole CenterOfMassJacobian center_of_mass_jacobian(q) -> [[T; 3]; N];
            /// The momentum of a robot.
            /// Γ₍₀₎ of what the joints move, pole at the origin of frame 0 [kg m²/s, kg m/s].
            whole Momentum momentum(q, qd) -> $crate::Momentum<T>;
            /// The momentum about the centre of mass.
            /// Γ of what the joints move about their centre of mass, in the axes of frame 0.
            whole CentroidalMomentum centroidal_momentum(q, qd) -> $crate::Momentum<T>;
            /// What each joint adds to the momentum about the centre of mass.
            /// Γ about the centre of mass at a unit rate of each joint, in the axes of frame 0.
            whole CentroidalMomentumMatrix centroidal_momentum_matrix(q) -> [$crate::Momentum<T>; N];
            /// What changes the momentum about the centre of mass at q̈ = 0.
            /// The rate of the centroidal momentum matrix times q̇, in the axes of frame 0 [N m, N].
            whole CentroidalMomentumBias centroidal_momentum_bias(q, qd) -> $crate::Action<T>;
            /// What changes of q and q̇ do to the torques of a motion.
            /// ∂τ/∂q and ∂τ/∂q̇ of inverse dynamics, a row for each torque or force.
            whole InverseDynamicsDerivatives inverse_dynamics_derivatives(q, qd, qdd) -> $crate::InverseDynamicsDerivatives<N, T>;
            /// What changes of q, q̇ and τ do to the accelerations.
            /// ∂q̈/∂q, ∂q̈/∂q̇ and ∂q̈/∂τ of forward dynamics, a row for each acceleration.
            solution ForwardDynamicsDerivatives forward_dynamics_derivatives(q, qd, tau) -> $crate::ForwardDynamicsDerivatives<N, T>;
            /// What a change of q does to the torques at rest.
            /// ∂τ/∂q of what holds the robot against gravity, a row for each torque or force.
            whole GravityDerivative gravity_derivative(q) -> [[T; N]; N];
            /// The Coriolis matrix.
            /// C(q, q̇) of τ = M q̈ + C q̇ + gravity, with Ṁ − 2C skew-symmetric, as rows.
            whole CoriolisMatrix coriolis_matrix(q, qd) -> [[T; N]; N];
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
        $kind:ident $name:ident $method:ident $arguments:tt -> $result:ty;
    )*) => {$(
        declare!($kind #[doc = $noun] $name: $(#[doc = $sentence])+ $method $arguments -> $result);
    )*};
}

macro_rules! declare {
    (chosen $($row:tt)*) => { declare!(sized $($row)*); };
    (sized $(#[$noun:meta])+ $name:ident: $($method:tt)*) => {
        declare!(@ [$(#[$noun])+ $name [const N: usize, const P: usize, T = f64, const Q: usize = N]] $($method)*);
    };
    ($kind:ident $(#[$noun:meta])+ $name:ident: $($method:tt)*) => {
        declare!(@ [$(#[$noun])+ $name [const N: usize, T = f64, const Q: usize = N]] $($method)*);
    };
    (@ [$(#[$noun:meta])+ $name:ident [$($generics:tt)+]]
        $(#[$about:meta])+ $method:ident($($argument:ident),*) -> $result:ty
    ) => {
        $(#[$noun])+
        #[diagnostic::on_unimplemented(
            message = "the robot `{Self}` lacks a function that is needed here",
            label = "needs a robot with this function",
            note = "add the function, the trait's name in snake case, to `generate(…)` of the robot: `generate(mass_matrix)` for `MassMatrix`"
        )]
        pub trait $name<$($generics)+> {
            $(#[$about])+
            #[must_use]
            fn $method(&self, $($argument: &$crate::robot::list_of!($argument)),*) -> $result;

            /// Whether what computes it is inlined into its caller, all of it, and makes its numbers
            /// [like](crate::Scalar::like) those of `q`: then it is compiled for the processor that its caller was
            /// compiled for, and batches hold its numbers in registers from the start.
            #[inline]
            #[must_use]
            fn is_inlined(&self) -> bool {
                false
            }
        }
    };
}
every_function!(traits);
