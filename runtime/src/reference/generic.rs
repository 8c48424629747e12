//! Every function of a robot, at run time, as the paper writes it (feature `nalgebra`).
//!
//! In: a [`Chain`](crate::Chain) and a state. Out: the results of generated code, by dense 4×4 products in frame 0
//! (Part II). It is the reference: short enough to compare with the paper line by line, without
//! simplifications, and therefore slow. It shares no code with the generator.
//!
//! A chain that [`check`](crate::Chain::check) rejects gives meaningless numbers, but no panic.
//!
//! ```
//! use homogen::{Chain, Inertia, Joint, Pose, Screw, generic};
//!
//! // A pendulum: 2 kg at 0.5 m below a hinge about y, in the frame of the hinge.
//! let hinge = Screw::new([0.0, 1.0, 0.0], [0.0; 3]);
//! let bob = Inertia::of_particle(2.0, [0.0, 0.0, -0.5]);
//! let chain: Chain<1, 0> = Chain::new(
//!     [Joint::new("hinge", None, Pose::identity(), hinge, bob)],
//!     [],
//!     [0.0, 0.0, -9.81],
//! );
//! let horizontal = core::f64::consts::FRAC_PI_2;
//! let [torque] = generic::gravity(&chain, &[horizontal]);
//! assert!((torque - 9.81).abs() < 1e-14);
//! ```

mod dynamics;
mod energy;
mod forward;
mod kinematics;
mod momentum;
mod weighted;

use nalgebra::RealField;

pub use super::closure::{
    actuated_inverse_dynamics, constrained_forward_dynamics, constraint, constraint_bias,
    constraint_jacobian,
};
pub use super::derivatives::{coriolis_matrix, gravity_derivative, inverse_dynamics_derivatives};
pub use super::hessian::inverse_dynamics_hessian;
pub use dynamics::{bias, gravity, inverse_dynamics, mass_matrix, regressor, torques_of_wrench};
pub use energy::{
    kinetic_energy, kinetic_energy_regressor, potential_energy, potential_energy_regressor,
};
pub use forward::{
    forward_dynamics, forward_dynamics_derivatives, forward_dynamics_parameter_derivatives,
    mass_matrix_inverse,
};
pub use kinematics::{
    acceleration, acceleration_bias, body_jacobian, body_jacobian_rate, forward_kinematics,
    forward_kinematics_hessian, geometric_jacobian, geometric_jacobian_rate, jacobian_derivative,
    spatial_jacobian, spatial_jacobian_rate, velocity,
};
pub use momentum::{
    center_of_mass, center_of_mass_jacobian, center_of_mass_velocity, centroidal_momentum,
    centroidal_momentum_bias, centroidal_momentum_matrix, momentum,
};
pub use weighted::{
    forward_dynamics_hessian, forward_dynamics_jvp, forward_dynamics_vjp, inverse_dynamics_jvp,
    inverse_dynamics_vjp,
};

/// Σ.
fn sum<T: RealField + Copy>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::zero(), |sum, term| sum + term)
}
