//! The functions that can be generated.
//!
//! The file of each function defines its name, arguments, result, expressions and reference as a `Definition`; `table`
//! has the methods by which all stages ask for them.

/// Calls a macro with every function: variant, file and doc comment; those of robots with loops are in braces, and after
/// them those of collision spheres.
macro_rules! every_function {
    ($then:ident) => {
        $then! {
            ForwardKinematics: forward_kinematics, "M₀,tip.";
            FramePoses: frame_poses, "M₀,₁ … M₀,ₙ of all requested frames.";
            SpatialJacobian: spatial_jacobian, "Columns L₁…L_N in the axes of frame 0, reference point at its origin.";
            BodyJacobian: body_jacobian, "Columns L₁…L_N in the axes of the end effector's frame, reference point at its origin.";
            GeometricJacobian: geometric_jacobian, "Columns L₁…L_N in the axes of frame 0, reference point at the end effector.";
            SpatialJacobianRate: spatial_jacobian_rate, "The time derivative of the spatial Jacobian.";
            BodyJacobianRate: body_jacobian_rate, "The time derivative of the entries of the body Jacobian.";
            GeometricJacobianRate: geometric_jacobian_rate, "The time derivative of the geometric Jacobian.";
            JacobianDerivative: jacobian_derivative, "The derivatives of the geometric Jacobian by the coordinates.";
            ForwardKinematicsHessian: forward_kinematics_hessian, "The derivative of the torques Jᵗ Φ of a wrench by the coordinates.";
            TipVelocity: velocity, "W₀,tip₍₀₎.";
            TipAcceleration: acceleration, "H₀,tip₍₀₎, without gravity.";
            AccelerationBias: acceleration_bias, "H₀,tip₍₀₎ at q̈ = 0, without gravity.";
            InverseDynamics: inverse_dynamics, "Joint torques and forces that produce q̈.";
            Gravity: gravity, "Inverse dynamics at rest.";
            Bias: bias, "Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms.";
            MassMatrix: mass_matrix, "The joint-space inertia matrix.";
            ForwardDynamics: forward_dynamics, "Joint accelerations that torques and forces produce.";
            MassMatrixInverse: mass_matrix_inverse, "The inverse of the joint-space inertia matrix.";
            KineticEnergy: kinetic_energy, "The kinetic energy ½ Σ Tr(W J Wᵗ) \\[J\\].";
            PotentialEnergy: potential_energy, "The potential energy −Σ Tr(H_g J) \\[J\\] of all bodies that joints move, zero at the origin of frame 0.";
            Regressor: regressor, "Y of τ = Y π, where π are the inertial parameters of the links.";
            BaseRegressor: base_regressor, "Y of τ = Y π, where π are the base parameters.";
            KineticEnergyRegressor: kinetic_energy_regressor, "The row y of T = y π, where T is the kinetic energy.";
            PotentialEnergyRegressor: potential_energy_regressor, "The row y of U = y π, where U is the potential energy.";
            CenterOfMass: center_of_mass, "The centre of mass of all bodies that joints move \\[m\\], in frame 0.";
            CenterOfMassVelocity: center_of_mass_velocity, "The velocity of the centre of mass [m/s].";
            CenterOfMassJacobian: center_of_mass_jacobian, "The Jacobian of the centre of mass.";
            TotalMomentum: momentum, "The momentum Γ₍₀₎ of all bodies that joints move.";
            CentroidalMomentum: centroidal_momentum, "Their momentum Γ about the centre of mass, in the axes of frame 0.";
            CentroidalMomentumMatrix: centroidal_momentum_matrix, "The centroidal momentum at unit velocity of each degree of freedom.";
            CentroidalMomentumBias: centroidal_momentum_bias, "The rate of change of the centroidal momentum at q̈ = 0.";
            InverseDynamicsDerivatives: inverse_dynamics_derivatives, "Derivatives of inverse dynamics by q and q̇.";
            InverseDynamicsVjp: inverse_dynamics_vjp, "The gradient of λᵀτ by q, q̇ and q̈, for weights λ of the torques.";
            InverseDynamicsJvp: inverse_dynamics_jvp, "τ, and its change along changes of q, q̇ and q̈.";
            InverseDynamicsHessian: inverse_dynamics_hessian, "Second derivatives of λᵀτ by q, q̇ and q̈, for weights λ of the torques.";
            ForwardDynamicsDerivatives: forward_dynamics_derivatives, "Derivatives of forward dynamics by q, q̇ and τ.";
            ForwardDynamicsVjp: forward_dynamics_vjp, "The gradient of λᵀq̈ by q, q̇ and τ, for weights λ of the accelerations.";
            ForwardDynamicsJvp: forward_dynamics_jvp, "q̈, and its change along changes of q, q̇ and τ.";
            ForwardDynamicsHessian: forward_dynamics_hessian, "Second derivatives of λᵀq̈ by q, q̇ and τ, for weights λ of the accelerations.";
            ForwardDynamicsParameterDerivatives: forward_dynamics_parameter_derivatives, "Derivatives of forward dynamics by the inertial parameters of the links.";
            GravityDerivative: gravity_derivative, "The derivative of gravity torques by q.";
            CoriolisMatrix: coriolis_matrix, "C of τ = M q̈ + C q̇ + gravity, with Ṁ = C + Cᵗ.";
            {
                Constraint: constraint, "The residuals of the loops.";
                ConstraintJacobian: constraint_jacobian, "The Jacobian of the residuals of the loops.";
                ConstraintBias: constraint_bias, "Second time derivatives of the residuals at q̈ = 0.";
                ConstrainedForwardDynamics: constrained_forward_dynamics, "Joint accelerations under the constraints of the loops, and constraint forces.";
                ActuatedInverseDynamics: actuated_inverse_dynamics, "Torques and forces of the actuated joints of a robot with loops that produce q̈.";
            }
            {
                SphereCenters: sphere_centers, "The centres of the collision spheres \\[m\\], in frame 0.";
                Distances: distances, "The distances between collision spheres \\[m\\], negative where they overlap.";
                DistanceJacobian: distance_jacobian, "The derivatives of these distances by q.";
            }
        }
    };
}

mod acceleration;
mod acceleration_bias;
mod actuated_inverse_dynamics;
mod base_regressor;
mod bias;
mod body_jacobian;
mod body_jacobian_rate;
mod center_of_mass;
mod center_of_mass_jacobian;
mod center_of_mass_velocity;
mod centroidal_momentum;
mod centroidal_momentum_bias;
mod centroidal_momentum_matrix;
mod constrained_forward_dynamics;
mod constraint;
mod constraint_bias;
mod constraint_jacobian;
mod coriolis_matrix;
mod definition;
#[cfg(feature = "files")]
mod derivatives;
mod distance_jacobian;
mod distances;
mod forward_dynamics;
mod forward_dynamics_derivatives;
mod forward_dynamics_hessian;
mod forward_dynamics_jvp;
mod forward_dynamics_parameter_derivatives;
mod forward_dynamics_vjp;
mod forward_kinematics;
mod forward_kinematics_hessian;
mod frame_poses;
mod geometric_jacobian;
mod geometric_jacobian_rate;
mod gravity;
mod gravity_derivative;
mod inverse_dynamics;
mod inverse_dynamics_derivatives;
mod inverse_dynamics_hessian;
mod inverse_dynamics_jvp;
mod inverse_dynamics_vjp;
mod jacobian_derivative;
mod kinetic_energy;
mod kinetic_energy_regressor;
mod mass_matrix;
mod mass_matrix_inverse;
mod momentum;
mod potential_energy;
mod potential_energy_regressor;
mod quantities;
mod regressor;
mod spatial_jacobian;
mod spatial_jacobian_rate;
mod sphere_centers;
mod table;
mod tally;
mod velocity;

pub use definition::Given;
pub(crate) use definition::Truth;
#[cfg(feature = "files")]
pub use derivatives::{Derivatives, First, Second};

macro_rules! functions {
    (
        $($variant:ident: $module:ident, $about:literal;)*
        { $($of_loops:ident: $_module:ident, $of_loops_about:literal;)* }
        { $($of_spheres:ident: $_of_spheres_module:ident, $of_spheres_about:literal;)* }
    ) => {
        /// A function of the state of a robot.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Function {
            $(#[doc = $about] $variant,)*
            $(#[doc = $of_loops_about] $of_loops,)*
            $(#[doc = $of_spheres_about] $of_spheres,)*
        }

        impl Function {
            /// Functions of every robot, in the order of the documentation.
            pub const ALL: [Self; [$($about),*].len()] = [$(Self::$variant),*];

            /// Additional functions of robots with loops.
            pub const OF_LOOPS: [Self; [$($of_loops_about),*].len()] = [$(Self::$of_loops),*];

            /// Additional functions of robots with collision spheres.
            pub const OF_SPHERES: [Self; [$($of_spheres_about),*].len()] = [$(Self::$of_spheres),*];
        }
    };
}
every_function!(functions);
