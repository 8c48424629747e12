//! A controller of an arm for a microcontroller.
//!
//! In: states of the arm. Out: poses, torques and accelerations, by the functions that `build.rs` generates. It needs
//! `core` only, computes in single precision, and cannot panic, allocate or loop.
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
