//! The functions that can be generated.
//!
//! A shared noun, and the list of all functions: what is known of one stands in its own file, as a
//! `Definition`, and every stage and every door asks it by way of `table`.

/// Calls a macro with every function: its file, and what it is; in braces those of robots with loops.
macro_rules! every_function {
    ($then:ident) => {
        $then! {
            ForwardKinematics: forward_kinematics, "M₀,tip.";
            SpatialJacobian: spatial_jacobian, "Columns L₁…L_N in frame 0, pole at its origin.";
            BodyJacobian: body_jacobian, "Columns L₁…L_N in the frame of the tip, pole at its origin.";
            GeometricJacobian: geometric_jacobian, "Columns in the axes of frame 0, pole at the origin of the tip.";
            SpatialJacobianRate: spatial_jacobian_rate, "The rate of the spatial Jacobian.";
            BodyJacobianRate: body_jacobian_rate, "The rate of the entries of the body Jacobian.";
            GeometricJacobianRate: geometric_jacobian_rate, "The rate of the geometric Jacobian.";
            TipVelocity: velocity, "W₀,tip₍₀₎.";
            TipAcceleration: acceleration, "H₀,tip₍₀₎, without gravity.";
            AccelerationBias: acceleration_bias, "H₀,tip₍₀₎ at q̈ = 0, without gravity.";
            InverseDynamics: inverse_dynamics, "Joint forces and torques that produce q̈.";
            Gravity: gravity, "Inverse dynamics at rest.";
            Bias: bias, "Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms.";
            MassMatrix: mass_matrix, "The joint-space inertia matrix.";
            ForwardDynamics: forward_dynamics, "Joint accelerations that forces and torques produce.";
            MassMatrixInverse: mass_matrix_inverse, "The inverse of the joint-space inertia matrix.";
            KineticEnergy: kinetic_energy, "The kinetic energy ½ Σ Tr(W J Wᵗ) \\[J\\].";
            PotentialEnergy: potential_energy, "The potential energy −Σ Tr(H_g J) \\[J\\] of what joints move, zero at the origin of frame 0.";
            Regressor: regressor, "Y of τ = Y π, where π are the inertial parameters of the links.";
            BaseRegressor: base_regressor, "Y of τ = Y π, where π are the base parameters.";
            CenterOfMass: center_of_mass, "The centre of mass of what joints move \\[m\\], in frame 0.";
            CenterOfMassVelocity: center_of_mass_velocity, "Its velocity [m/s].";
            CenterOfMassJacobian: center_of_mass_jacobian, "Its velocity at a unit rate of each joint.";
            TotalMomentum: momentum, "Γ₍₀₎ of what joints move.";
            CentroidalMomentum: centroidal_momentum, "Γ of what joints move about their centre of mass, in the axes of frame 0.";
            CentroidalMomentumMatrix: centroidal_momentum_matrix, "Its columns: Γ at a unit rate of each joint.";
            CentroidalMomentumBias: centroidal_momentum_bias, "What changes it at q̈ = 0.";
            InverseDynamicsDerivatives: inverse_dynamics_derivatives, "What changes of q and q̇ do to the torques of inverse dynamics.";
            ForwardDynamicsDerivatives: forward_dynamics_derivatives, "What changes of q, q̇ and τ do to the accelerations of forward dynamics.";
            GravityDerivative: gravity_derivative, "What a change of q does to the torques at rest.";
            CoriolisMatrix: coriolis_matrix, "C of τ = M q̈ + C q̇ + gravity, with Ṁ = C + Cᵗ.";
            {
                Constraint: constraint, "The residuals of the loops.";
                ConstraintJacobian: constraint_jacobian, "What velocities change them by.";
                ConstraintBias: constraint_bias, "Their accelerations at q̈ = 0.";
                ConstrainedForwardDynamics: constrained_forward_dynamics, "Joint accelerations that forces and torques produce where loops are held together, and what holds them.";
                ActuatedInverseDynamics: actuated_inverse_dynamics, "The torques and forces of driven joints that produce q̈, where loops move the others.";
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
mod forward_dynamics;
mod forward_dynamics_derivatives;
mod forward_kinematics;
mod geometric_jacobian;
mod geometric_jacobian_rate;
mod gravity;
mod gravity_derivative;
mod inverse_dynamics;
mod inverse_dynamics_derivatives;
mod kinetic_energy;
mod mass_matrix;
mod mass_matrix_inverse;
mod momentum;
mod potential_energy;
mod quantities;
mod regressor;
mod spatial_jacobian;
mod spatial_jacobian_rate;
mod table;
mod tally;
mod velocity;

pub use definition::Given;
pub(crate) use definition::Truth;

macro_rules! functions {
    (
        $($variant:ident: $module:ident, $about:literal;)*
        { $($of_loops:ident: $_module:ident, $of_loops_about:literal;)* }
    ) => {
        /// A function of the state of a robot.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Function {
            $(#[doc = $about] $variant,)*
            $(#[doc = $of_loops_about] $of_loops,)*
        }

        impl Function {
            /// All that every robot can have, in the order of the documentation.
            pub const ALL: [Self; [$($about),*].len()] = [$(Self::$variant),*];

            /// Those that a robot with loops can have besides.
            pub const OF_LOOPS: [Self; [$($of_loops_about),*].len()] = [$(Self::$of_loops),*];
        }
    };
}
every_function!(functions);
