//! A controller of an arm, as it would be flashed.
//!
//! In: states of the arm. Out: poses, torques and accelerations, by the functions that `build.rs`
//! generated. It needs `core` alone, is in single precision throughout, and has no path on which it
//! could panic, allocate or loop.
#![no_std]

mod arm;
mod control;
pub mod sines;
mod states;

pub use control::{
    computed_torque, forward_dynamics, forward_kinematics, geometric_jacobian, gravity,
    inverse_dynamics, mass_matrix,
};
pub use states::{EVERYDAY, JOINTS, Joints, STATES, State, TRUSTED, states};
