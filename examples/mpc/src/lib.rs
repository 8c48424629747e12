//! Model-predictive control of an arm on a microcontroller.
//!
//! In: the arm's description, a goal and limits; then states. Out: torques. [`admm`] is the solver for any linear system,
//! [`arm`] the arm's A and B from generated code and its simulation.
#![cfg_attr(not(test), no_std)]

pub mod admm;
pub mod arm;
