//! The 4×4 matrices that motion and its causes are written in, each a type of its own.
//!
//! Here belong the letters of the paper, M, Q, L, W, H, J, Γ and Φ, with the blocks that they are
//! made of, the change of frame, and what can be wrong with one of them. They are the arguments and
//! results of every robot. What takes several bodies, or a choice of angles, axes or points, is not
//! here but in the rooms that use these types.

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
