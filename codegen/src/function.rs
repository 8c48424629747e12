//! The functions that can be generated.
//!
//! A shared noun, and the list of all functions: what is known of one stands in its own file, as a
//! `Definition`, and every stage and every door asks it by way of `table`.

/// Calls a macro with every function: its file, and what it is.
macro_rules! every_function {
    ($then:ident) => {
        $then! {
            ForwardKinematics: forward_kinematics, "M₀,tip.";
            SpatialJacobian: spatial_jacobian, "Columns L₁…L_N in frame 0, pole at its origin.";
            BodyJacobian: body_jacobian, "Columns L₁…L_N in the frame of the tip, pole at its origin.";
            GeometricJacobian: geometric_jacobian, "Columns in the axes of frame 0, pole at the origin of the tip.";
            Velocity: velocity, "W₀,tip₍₀₎.";
            Acceleration: acceleration, "H₀,tip₍₀₎, without gravity.";
            InverseDynamics: inverse_dynamics, "Joint forces and torques that produce q̈.";
            Gravity: gravity, "Inverse dynamics at rest.";
            Bias: bias, "Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms.";
            MassMatrix: mass_matrix, "The joint-space inertia matrix.";
            ForwardDynamics: forward_dynamics, "Joint accelerations that forces and torques produce.";
            MassMatrixInverse: mass_matrix_inverse, "The inverse of the joint-space inertia matrix.";
            KineticEnergy: kinetic_energy, "The kinetic energy ½ Σ Tr(W J Wᵗ) \\[J\\].";
            PotentialEnergy: potential_energy, "The potential energy −Σ Tr(H_g J) \\[J\\] of what joints move, zero at the origin of frame 0.";
        }
    };
}

mod acceleration;
mod bias;
mod body_jacobian;
mod definition;
mod forward_dynamics;
mod forward_kinematics;
mod geometric_jacobian;
mod gravity;
mod inverse_dynamics;
mod kinetic_energy;
mod mass_matrix;
mod mass_matrix_inverse;
mod potential_energy;
mod quantities;
mod spatial_jacobian;
mod table;
mod tally;
mod velocity;

pub use definition::Given;
pub(crate) use definition::Truth;

macro_rules! functions {
    ($($variant:ident: $module:ident, $about:literal;)*) => {
        /// A function of the state of a robot.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Function {
            $(#[doc = $about] $variant,)*
        }

        impl Function {
            /// All of them, in the order of the documentation.
            pub const ALL: [Self; [$($about),*].len()] = [$(Self::$variant),*];
        }
    };
}
every_function!(functions);
