#![doc = include_str!("guide.md")]
#![no_std]

#[cfg(feature = "std")]
extern crate std;

mod acceleration;
mod action;
pub mod angles;
mod chain;
#[doc = include_str!("checklist.md")]
pub mod checklist {}
#[cfg(feature = "nalgebra")]
mod conversion;
pub mod denavit_hartenberg;
mod displacement;
mod error;
pub mod frames;
#[cfg(feature = "nalgebra")]
pub mod generic;
pub mod geometry;
mod inertia;
mod jacobian;
mod logarithm;
mod momentum;
pub mod newton_euler;
pub mod normalize;
mod physical;
mod point;
mod pose;
pub mod robot;
pub mod rotation;
mod scalar;
mod screw;
mod symmetric;
mod tensor;
#[cfg(feature = "approx")]
mod tolerance;
pub mod vector;
mod velocity;

pub use acceleration::Acceleration;
pub use action::Action;
pub use chain::{Chain, Frame, Joint};
pub use displacement::Displacement;
pub use error::Error;
pub use inertia::Inertia;
pub use jacobian::Jacobian;
pub use momentum::Momentum;
pub use point::{Direction, Point};
pub use pose::Pose;
pub use scalar::{Real, Scalar};
pub use screw::Screw;
pub use tensor::Tensor;
pub use velocity::Velocity;

#[cfg(feature = "derive")]
pub use homogen_macros::{Robot, chain};
