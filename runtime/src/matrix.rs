//! The 4×4 matrices of the paper, M, Q, L, W, H, J, Γ and Φ, each a type of its own.
//!
//! They are the arguments and results of robots. This module has their blocks, their change of frame and
//! their checks; other modules treat several bodies, and angles, axes or points.

mod acceleration;
mod action;
#[cfg(feature = "nalgebra")]
mod conversion;
mod displacement;
mod display;
mod form;
mod inertia;
mod momentum;
mod physical;
mod point;
mod pose;
pub mod rotation;
mod screw;
pub(crate) mod symmetric;
mod tensor;
#[cfg(feature = "approx")]
mod tolerance;
pub mod vector;
mod velocity;

pub use acceleration::Acceleration;
pub use action::Action;
pub use displacement::Displacement;
pub use inertia::Inertia;
pub use momentum::Momentum;
pub use point::{Direction, Point};
pub use pose::Pose;
pub use screw::Screw;
pub use tensor::Tensor;
pub use velocity::Velocity;
