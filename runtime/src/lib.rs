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
pub mod lagrange;
mod logarithm;
pub mod loop_closure;
mod momentum;
pub mod newton_euler;
pub mod normalize;
pub mod open_chain;
mod physical;
mod point;
mod pose;
pub mod robot;
pub mod rotation;
mod scalar;
mod screw;
mod singular_values;
mod symmetric;
mod tensor;
#[cfg(feature = "approx")]
mod tolerance;
pub mod trigonometry;
pub mod vector;
mod velocity;
#[cfg(any(feature = "std", feature = "libm"))]
pub mod worked_examples;

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
