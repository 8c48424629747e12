//! One small trait for each function of a robot.
//!
//! In: joint coordinates `q`, velocities `qd` and accelerations `qdd` (rad or m, and seconds). Out:
//! arrays and typed matrices. Generated robots and [`crate::Chain`] implement these traits, so that
//! a controller can be written for any robot that has the functions it needs.
//!
//! `N` is the number of degrees of freedom, `Q` the number of coordinates. They are equal if every joint has
//! one coordinate, and `Q` need not be written then. [`Motion`](crate::Motion) lists the coordinates and
//! velocities of each type of joint. The tip is the end effector: the first frame of the robot.
//!
//! ```
//! use homogen::robot::{Gravity, InverseDynamics};
//!
//! /// Torques that hold a robot still.
//! fn hold<R: Gravity<N>, const N: usize>(robot: &R, q: &[f64; N]) -> [f64; N] {
//!     robot.gravity(q)
//! }
//! ```

// This module holds robots as data and operations on results; the computation of functions is elsewhere.
pub(crate) mod actuator;
mod batched;
pub(crate) mod chain;
#[cfg(any(feature = "std", feature = "libm"))]
mod check;
pub(crate) mod closed_loops;
pub(crate) mod constrained;
pub(crate) mod derivatives;
pub(crate) mod described;
pub(crate) mod jacobian;
pub(crate) mod joint;
mod loops;
pub mod manifold;
pub(crate) mod payload;
pub(crate) mod step;

pub use batched::Batched;
#[cfg(feature = "batch")]
pub(crate) use batched::is_inlined;
pub use loops::*;

/// Calls a macro with one row for every function: a noun, a hint for robots without it, its result with units, its kind,
/// its trait, and its method with arguments and result.
///
/// | kind | function |
/// |---|---|
/// | `tip` | of the end effector's frame |
/// | `tip_weighted` | the same, contracted with a wrench `wrench` |
/// | `whole` | of the whole robot |
/// | `weighted` | of the whole robot, contracted with weights `weights` |
/// | `directed` | of the whole robot, along changes of its arguments: `q_change`, `qd_change`, … |
/// | `solution` | of the whole robot, by solving linear equations |
/// | `sized` | of the whole robot, with `P` numbers in a row of the result |
/// | `chosen` | the same, not implemented for chains, which do not know their base parameters |
///
/// Internal: traits, their implementations and tests are made from this list.
#[doc(hidden)]
#[macro_export]
macro_rules! every_function {
    ($then:ident) => {
        $then! {
            /// The pose of the tip.
            #[doc = "add `forward_kinematics` to `generate(…)` of the robot"]
            /// M₀,tip.
            tip ForwardKinematics forward_kinematics(q) -> $crate::Pose<T>;
            /// The poses of all frames.
            #[doc = "add `frame_poses` to `generate(…)` of the robot"]
            /// M₀,₁ … M₀,ₙ of the tip, if there is one, and of the other frames in the order in which they are named.
            chosen FramePoses frame_poses(q) -> [$crate::Pose<T>; P];
            /// The Jacobian in frame 0.
            #[doc = "add `spatial_jacobian` to `generate(…)` of the robot"]
            /// L₁ … L_N, in frame 0, reference point at its origin.
            tip SpatialJacobian spatial_jacobian(q) -> [$crate::Screw<T>; N];
            /// The Jacobian in the frame of the tip.
            #[doc = "add `body_jacobian` to `generate(…)` of the robot"]
            /// L₁ … L_N, in the frame of the tip, reference point at its origin.
            tip BodyJacobian body_jacobian(q) -> [$crate::Screw<T>; N];
            /// The Jacobian with the axes of frame 0 and the reference point at the tip.
            #[doc = "add `geometric_jacobian` to `generate(…)` of the robot"]
            /// L₁ … L_N, with the axes of frame 0, reference point at the origin of the tip.
            tip GeometricJacobian geometric_jacobian(q) -> [$crate::Screw<T>; N];
            /// The rate of the Jacobian in frame 0.
            #[doc = "add `spatial_jacobian_rate` to `generate(…)` of the robot"]
            /// L̇₁ … L̇_N of its columns [1/s, m/s].
            tip SpatialJacobianRate spatial_jacobian_rate(q, qd) -> [$crate::Screw<T>; N];
            /// The rate of the Jacobian in the frame of the tip.
            #[doc = "add `body_jacobian_rate` to `generate(…)` of the robot"]
            /// L̇₁ … L̇_N of its columns, entry by entry in the moving axes of the tip [1/s, m/s].
            tip BodyJacobianRate body_jacobian_rate(q, qd) -> [$crate::Screw<T>; N];
            /// The rate of the Jacobian with the axes of frame 0 and the reference point at the tip.
            #[doc = "add `geometric_jacobian_rate` to `generate(…)` of the robot"]
            /// L̇₁ … L̇_N of its columns, whose reference point moves with the tip [1/s, m/s].
            tip GeometricJacobianRate geometric_jacobian_rate(q, qd) -> [$crate::Screw<T>; N];
            /// The derivatives of the Jacobian with the axes of frame 0 and the reference point at the tip.
            #[doc = "add `jacobian_derivative` to `generate(…)` of the robot"]
            /// ∂L/∂q of the columns of the geometric Jacobian, a Jacobian for each coordinate \[1, m, 1/m\], or along each
            /// velocity of a joint with a quaternion.
            tip JacobianDerivative jacobian_derivative(q) -> [[$crate::Screw<T>; N]; N];
            /// The kinematic Hessian of the tip, contracted with a wrench.
            #[doc = "add `forward_kinematics_hessian` to `generate(…)` of the robot"]
            /// ∂(Jᵗ Φ)/∂q of the geometric Jacobian J for a constant wrench Φ at the origin of the tip in the axes of frame 0,
            /// `wrench`: couple \[N m\], then force \[N\]; a row for each torque or force of Jᵗ Φ [N m, N, N/m].
            tip_weighted ForwardKinematicsHessian forward_kinematics_hessian(q, wrench) -> [[T; N]; N];
            /// The velocity of the tip.
            #[doc = "add `velocity` to `generate(…)` of the robot"]
            /// W₀,tip₍₀₎, in rad/s and m/s.
            tip TipVelocity velocity(q, qd) -> $crate::Velocity<T>;
            /// The acceleration of the tip.
            #[doc = "add `acceleration` to `generate(…)` of the robot"]
            /// H₀,tip₍₀₎, without gravity.
            tip TipAcceleration acceleration(q, qd, qdd) -> $crate::Acceleration<T>;
            /// The acceleration of the tip at q̈ = 0.
            #[doc = "add `acceleration_bias` to `generate(…)` of the robot"]
            /// H₀,tip₍₀₎ due to the velocities alone, without gravity.
            tip AccelerationBias acceleration_bias(q, qd) -> $crate::Acceleration<T>;
            /// The joint torques and forces of a motion.
            #[doc = "add `inverse_dynamics` to `generate(…)` of the robot"]
            /// τ: the torques [N m] and forces \[N\] of the joints that produce q̈ under gravity.
            whole InverseDynamics inverse_dynamics(q, qd, qdd) -> [T; N];
            /// The joint torques and forces at rest.
            #[doc = "add `gravity` to `generate(…)` of the robot"]
            /// Inverse dynamics at rest: the torques and forces that hold the robot against gravity [N m, N].
            whole Gravity gravity(q) -> [T; N];
            /// The joint torques and forces at q̈ = 0.
            #[doc = "add `bias` to `generate(…)` of the robot"]
            /// Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms [N m, N].
            whole Bias bias(q, qd) -> [T; N];
            /// The joint-space inertia matrix.
            #[doc = "add `mass_matrix` to `generate(…)` of the robot"]
            /// M(q) of τ = M q̈ + bias: symmetric, as rows.
            whole MassMatrix mass_matrix(q) -> [[T; N]; N];
            /// The joint accelerations due to torques and forces.
            #[doc = "add `forward_dynamics` to `generate(…)` of the robot"]
            /// The accelerations [rad/s², m/s²] that torques \[N m\] and forces \[N\] of the joints produce
            /// under gravity.
            solution ForwardDynamics forward_dynamics(q, qd, tau) -> [T; N];
            /// The inverse of the joint-space inertia matrix.
            #[doc = "add `mass_matrix_inverse` to `generate(…)` of the robot"]
            /// M(q)⁻¹: symmetric, as rows.
            solution MassMatrixInverse mass_matrix_inverse(q) -> [[T; N]; N];
            /// The kinetic energy.
            #[doc = "add `kinetic_energy` to `generate(…)` of the robot"]
            /// ½ Σ Tr(W J Wᵗ) \[J\].
            whole KineticEnergy kinetic_energy(q, qd) -> T;
            /// The potential energy.
            #[doc = "add `potential_energy` to `generate(…)` of the robot"]
            /// −Σ Tr(H_g J) over the bodies that joints move \[J\], zero at the origin of frame 0.
            whole PotentialEnergy potential_energy(q) -> T;
            /// The regressor of the joint torques and forces on the inertial parameters.
            #[doc = "add `regressor` to `generate(…)` of the robot"]
            /// Y of τ = Y π, by rows; π lists for each link m, q_x, q_y, q_z, J_xx, J_xy, J_xz, J_yy, J_yz, J_zz in
            /// its own frame [kg, kg m, kg m²].
            sized Regressor regressor(q, qd, qdd) -> [[T; P]; N];
            /// The regressor of the joint torques and forces on the base parameters.
            #[doc = "add `base_regressor` to `generate(…)` of the robot"]
            /// Y of τ = Y π, by rows, where π are the base parameters: the linear combinations of inertial parameters
            /// that torques determine.
            chosen BaseRegressor base_regressor(q, qd, qdd) -> [[T; P]; N];
            /// The regressor of the kinetic energy on the inertial parameters.
            #[doc = "add `kinetic_energy_regressor` to `generate(…)` of the robot"]
            /// The row y of T = y π, for the parameters π of [`Regressor`].
            sized KineticEnergyRegressor kinetic_energy_regressor(q, qd) -> [T; P];
            /// The regressor of the potential energy on the inertial parameters.
            #[doc = "add `potential_energy_regressor` to `generate(…)` of the robot"]
            /// The row y of U = y π, for the parameters π of [`Regressor`]; U is zero at the origin of frame 0.
            sized PotentialEnergyRegressor potential_energy_regressor(q) -> [T; P];
            /// The centre of mass.
            #[doc = "add `center_of_mass` to `generate(…)` of the robot"]
            /// The centre of mass of the bodies that joints move, in frame 0 \[m\].
            whole CenterOfMass center_of_mass(q) -> $crate::Point<T>;
            /// The velocity of the centre of mass.
            #[doc = "add `center_of_mass_velocity` to `generate(…)` of the robot"]
            /// The velocity of the centre of mass of the bodies that joints move, in the axes of frame 0 [m/s].
            whole CenterOfMassVelocity center_of_mass_velocity(q, qd) -> [T; 3];
            /// The Jacobian of the centre of mass.
            #[doc = "add `center_of_mass_jacobian` to `generate(…)` of the robot"]
            /// One column a joint: the velocity of the centre of mass at a unit rate of the joint, in the axes of frame 0
            /// [m, or 1 for prismatic joints].
            whole CenterOfMassJacobian center_of_mass_jacobian(q) -> [[T; 3]; N];
            /// The momentum of a robot.
            #[doc = "add `momentum` to `generate(…)` of the robot"]
            /// Γ₍₀₎ of the bodies that joints move, reference point at the origin of frame 0 [kg m²/s, kg m/s].
            whole TotalMomentum momentum(q, qd) -> $crate::Momentum<T>;
            /// The momentum about the centre of mass.
            #[doc = "add `centroidal_momentum` to `generate(…)` of the robot"]
            /// Γ of the bodies that joints move, about their centre of mass, in the axes of frame 0 [kg m²/s, kg m/s].
            whole CentroidalMomentum centroidal_momentum(q, qd) -> $crate::Momentum<T>;
            /// The matrix of the momentum about the centre of mass.
            #[doc = "add `centroidal_momentum_matrix` to `generate(…)` of the robot"]
            /// One column a joint: Γ about the centre of mass at a unit rate of the joint, in the axes of frame 0
            /// [kg m², kg m, kg].
            whole CentroidalMomentumMatrix centroidal_momentum_matrix(q) -> [$crate::Momentum<T>; N];
            /// The rate of the momentum about the centre of mass at q̈ = 0.
            #[doc = "add `centroidal_momentum_bias` to `generate(…)` of the robot"]
            /// The rate of the centroidal momentum matrix times q̇, in the axes of frame 0 [N m, N].
            whole CentroidalMomentumBias centroidal_momentum_bias(q, qd) -> $crate::Action<T>;
            /// The derivatives of inverse dynamics by q and q̇.
            #[doc = "add `inverse_dynamics_derivatives` to `generate(…)` of the robot"]
            /// ∂τ/∂q and ∂τ/∂q̇ of inverse dynamics, a row for each torque or force.
            whole InverseDynamicsDerivatives inverse_dynamics_derivatives(q, qd, qdd) -> $crate::TorqueDerivatives<N, T>;
            /// The gradient of λᵀτ by q, q̇ and q̈.
            #[doc = "add `inverse_dynamics_vjp` to `generate(…)` of the robot"]
            /// The vector–Jacobian product of inverse dynamics: (∂τ/∂q)ᵀ λ, (∂τ/∂q̇)ᵀ λ and M λ.
            weighted InverseDynamicsVjp inverse_dynamics_vjp(q, qd, qdd, weights) -> $crate::TorqueGradient<N, T>;
            /// The joint torques and forces of a motion, and their change along a direction.
            #[doc = "add `inverse_dynamics_jvp` to `generate(…)` of the robot"]
            /// The Jacobian–vector product of inverse dynamics: τ, and δτ = (∂τ/∂q) δq + (∂τ/∂q̇) δq̇ + M δq̈.
            directed InverseDynamicsJvp inverse_dynamics_jvp(q, qd, qdd, q_change, qd_change, qdd_change) -> $crate::TorqueChange<N, T>;
            /// The second derivatives of λᵀτ by q, q̇ and q̈.
            #[doc = "add `inverse_dynamics_hessian` to `generate(…)` of the robot"]
            /// The Hessian of λᵀτ, with the torques of inverse dynamics and their weights λ.
            weighted InverseDynamicsHessian inverse_dynamics_hessian(q, qd, qdd, weights) -> $crate::TorqueHessian<N, T>;
            /// The derivatives of forward dynamics by q, q̇ and τ.
            #[doc = "add `forward_dynamics_derivatives` to `generate(…)` of the robot"]
            /// ∂q̈/∂q, ∂q̈/∂q̇ and ∂q̈/∂τ of forward dynamics, a row for each acceleration.
            solution ForwardDynamicsDerivatives forward_dynamics_derivatives(q, qd, tau) -> $crate::AccelerationDerivatives<N, T>;
            /// The gradient of λᵀq̈ by q, q̇ and τ.
            #[doc = "add `forward_dynamics_vjp` to `generate(…)` of the robot"]
            /// The vector–Jacobian product of forward dynamics: (∂q̈/∂q)ᵀ λ, (∂q̈/∂q̇)ᵀ λ and M⁻¹ λ.
            weighted ForwardDynamicsVjp forward_dynamics_vjp(q, qd, tau, weights) -> $crate::AccelerationGradient<N, T>;
            /// The joint accelerations due to torques and forces, and their change along a direction.
            #[doc = "add `forward_dynamics_jvp` to `generate(…)` of the robot"]
            /// The Jacobian–vector product of forward dynamics: q̈, and δq̈ = (∂q̈/∂q) δq + (∂q̈/∂q̇) δq̇ + M⁻¹ δτ.
            directed ForwardDynamicsJvp forward_dynamics_jvp(q, qd, tau, q_change, qd_change, tau_change) -> $crate::AccelerationChange<N, T>;
            /// The second derivatives of λᵀq̈ by q, q̇ and τ.
            #[doc = "add `forward_dynamics_hessian` to `generate(…)` of the robot"]
            /// The Hessian of λᵀq̈, with the accelerations of forward dynamics and their weights λ.
            weighted ForwardDynamicsHessian forward_dynamics_hessian(q, qd, tau, weights) -> $crate::AccelerationHessian<N, T>;
            /// The derivatives of forward dynamics by the inertial parameters.
            #[doc = "add `forward_dynamics_parameter_derivatives` to `generate(…)` of the robot"]
            /// ∂q̈/∂π = −M⁻¹ Y of forward dynamics, for the parameters π of [`Regressor`] and its Y at q̈, a row for each
            /// acceleration.
            sized ForwardDynamicsParameterDerivatives forward_dynamics_parameter_derivatives(q, qd, tau) -> [[T; P]; N];
            /// The derivative of the torques at rest by q.
            #[doc = "add `gravity_derivative` to `generate(…)` of the robot"]
            /// ∂τ/∂q of `gravity`, a row for each torque or force [N m, N, N/m].
            whole GravityDerivative gravity_derivative(q) -> [[T; N]; N];
            /// The Coriolis matrix.
            #[doc = "add `coriolis_matrix` to `generate(…)` of the robot"]
            /// C(q, q̇) of τ = M q̈ + C q̇ + gravity, with Ṁ − 2C skew-symmetric, as rows.
            whole CoriolisMatrix coriolis_matrix(q, qd) -> [[T; N]; N];
        }
    };
}

/// The same for the functions of robots with collision spheres.
#[doc(hidden)]
#[macro_export]
macro_rules! every_function_of_spheres {
    ($then:ident) => {
        $then! {
            /// The centres of collision spheres.
            #[doc = "add `sphere_centers` to `generate(…)` of the robot, and `collision` beside it"]
            /// The centres of the spheres in frame 0 \[m\], in the order of `SPHERES`.
            chosen SphereCenters sphere_centers(q) -> [$crate::Point<T>; P];
            /// The distances between collision spheres.
            #[doc = "add `distances` to `generate(…)` of the robot, and `collision` beside it"]
            /// |c₁ − c₂| − r₁ − r₂ of the pairs of spheres in the order of `PAIRS` \[m\], negative where they overlap.
            chosen Distances distances(q) -> [T; P];
            /// The derivatives of the distances between collision spheres.
            #[doc = "add `distance_jacobian` to `generate(…)` of the robot, and `collision` beside it"]
            /// The derivatives of `distances` by q, a row for each pair [m, or 1 for prismatic joints]; not finite where two
            /// centres coincide.
            chosen DistanceJacobian distance_jacobian(q) -> [[T; N]; P];
        }
    };
}

/// The array type of an argument: `Q` entries for `q`, six for `wrench`, `N` for all others.
macro_rules! list_of {
    (q) => {
        [T; Q]
    };
    (wrench) => {
        [T; 6]
    };
    ($other:ident) => {
        [T; N]
    };
}
pub(crate) use list_of;

macro_rules! traits {
    ($(
        #[doc = $noun:literal]
        #[doc = $hint:literal]
        $(#[doc = $sentence:literal])+
        $kind:ident $name:ident $method:ident $arguments:tt -> $result:ty;
    )*) => {$(
        declare!($kind $noun $hint [$($sentence)+] $name: $method $arguments -> $result);
    )*};
}

macro_rules! declare {
    (chosen $($row:tt)*) => { declare!(sized $($row)*); };
    (sized $noun:literal $hint:literal $about:tt $name:ident: $($method:tt)*) => {
        declare!(@ $noun $hint $about $name [const N: usize, const P: usize, T = f64, const Q: usize = N] $($method)*);
    };
    ($kind:ident $noun:literal $hint:literal $about:tt $name:ident: $($method:tt)*) => {
        declare!(@ $noun $hint $about $name [const N: usize, T = f64, const Q: usize = N] $($method)*);
    };
    (@ $noun:literal $hint:literal [$($sentence:literal)+] $name:ident [$($generics:tt)+]
        $method:ident($($argument:ident),*) -> $result:ty
    ) => {
        #[doc = $noun]
        #[diagnostic::on_unimplemented(
            message = "the robot `{Self}` lacks a function that is needed here",
            label = "needs a robot with this function",
            note = $hint
        )]
        pub trait $name<$($generics)+> {
            $(#[doc = $sentence])+
            #[must_use]
            fn $method(&self, $($argument: &$crate::robot::list_of!($argument)),*) -> $result;
        }
    };
}
every_function!(traits);
every_function_of_spheres!(traits);
