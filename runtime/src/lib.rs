#![doc = include_str!("front.md")]
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "std")]
extern crate std;

#[doc = include_str!("checklist.md")]
pub mod checklist {}
#[cfg(feature = "batch")]
pub mod batch;
mod error;
#[doc = include_str!("guide.md")]
pub mod guide {}
pub mod identify;
pub mod ik;
mod matrix;
mod paper;
#[cfg(feature = "nalgebra")]
mod reference;
pub mod robot;
mod scalar;
pub mod step;

pub use error::Error;
pub use matrix::{
    Acceleration, Action, Direction, Displacement, Inertia, Momentum, Point, Pose, Screw, Tensor,
    Velocity, rotation, vector,
};
#[cfg(any(feature = "std", feature = "libm"))]
pub use paper::worked_examples;
pub use paper::{
    angles, denavit_hartenberg, frames, geometry, lagrange, loop_closure, newton_euler, normalize,
    open_chain,
};
#[cfg(feature = "nalgebra")]
pub use reference::generic;
pub use robot::actuator::JointActuator;
pub use robot::chain::{Chain, Frame};
pub use robot::closed_loops::{ClosedLoopRobot, Residual, ResidualKind};
pub use robot::constrained::ConstrainedAccelerations;
pub use robot::derivatives::{
    AccelerationChange, AccelerationDerivatives, AccelerationGradient, AccelerationHessian,
    TorqueChange, TorqueDerivatives, TorqueGradient, TorqueHessian,
};
pub use robot::described::Robot;
pub use robot::jacobian::Jacobian;
pub use robot::joint::{Joint, Motion};
pub use robot::payload::Payload;
#[doc(hidden)]
pub use scalar::dispatch;
#[cfg(any(feature = "std", feature = "libm"))]
pub use scalar::{Lane, Pack};
pub use scalar::{Real, Scalar, rounding, trigonometry};

#[cfg(feature = "derive")]
pub use homogen_macros::{Robot, chain};
