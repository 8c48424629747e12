//! Robots of the tests, each derived once.
//!
//! In: robots/*.urdf, and inline descriptions. Out: a struct for each robot, and macros that run a test for each.
//! They are a crate of their own, so that no other change of the tests derives them again. Only two of them are
//! documented, since the text of generated documentation is the same for all.

pub mod jointed;
pub mod shipped;

/// Calls a macro with the names of the functions that `homogen_tests::functions::evaluate` compares, as `generate`
/// reads them, and with further tokens: for robots of which few other functions are called. Second derivatives and
/// gradients take most of the time of an expansion.
#[macro_export]
macro_rules! with_every_function {
    ($run:ident! $($rest:tt)*) => {
        $run! {
            [
                forward_kinematics, spatial_jacobian, body_jacobian, geometric_jacobian,
                spatial_jacobian_rate, body_jacobian_rate, geometric_jacobian_rate,
                jacobian_derivative,
                velocity, acceleration, acceleration_bias,
                inverse_dynamics, gravity, bias, mass_matrix, kinetic_energy, potential_energy,
                center_of_mass, center_of_mass_velocity, center_of_mass_jacobian,
                momentum, centroidal_momentum, centroidal_momentum_matrix, centroidal_momentum_bias,
                inverse_dynamics_derivatives, gravity_derivative, coriolis_matrix
            ]
            $($rest)*
        }
    };
}
