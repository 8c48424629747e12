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

// Each of these files defines the functions of its kind and nothing else that is public.
pub use super::closure::*;
pub use super::derivatives::*;
pub use super::hessian::*;
pub use dynamics::*;
pub use energy::*;
pub use forward::*;
pub use kinematics::*;
pub use momentum::*;
pub use weighted::*;

/// Σ.
fn sum<T: RealField + Copy>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::zero(), |sum, term| sum + term)
}
