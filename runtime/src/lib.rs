//! Rigid bodies with 4×4 matrices.
#![no_std]

#[cfg(feature = "std")]
extern crate std;

mod acceleration;
mod action;
mod chain;
mod displacement;
#[cfg(feature = "nalgebra")]
pub mod generic;
mod inertia;
mod jacobian;
mod momentum;
mod point;
mod pose;
pub mod robot;
mod scalar;
mod screw;
mod tensor;
pub mod trigonometry;
pub mod vector;
mod velocity;

pub use acceleration::Acceleration;
pub use action::Action;
pub use chain::{Chain, Frame, Joint};
pub use displacement::Displacement;
pub use inertia::Inertia;
pub use jacobian::Jacobian;
pub use momentum::Momentum;
pub use point::{Direction, Point};
pub use pose::Pose;
pub use scalar::{Real, Scalar};
pub use screw::Screw;
pub use tensor::Tensor;
pub use velocity::Velocity;
