//! Chains and states that are hard cases of arithmetic, each with a name and a limit.
//!
//! In: robots of [`homogen_tests::subjects`], seeded states. Out: errors in units of rounding, compared with 256 bits,
//! in double and in single precision, each fused and unfused, and in single precision without subnormal numbers.
//!
//! - Limits are the same for fused and unfused products; fusing saves roundings, and median errors are 5 % smaller.
//! - In every sixth state the robot is at rest, and in every sixth its rates are subnormal.
//! - Arguments are exact in every type. Numbers of the robot are exact in the 256 bits, so their rounding to the type
//!   is part of the error.
//! - Limits are targets where they were known in advance, and otherwise about twice the measured error, as documented.

mod angles;
mod cancelling;
mod case;
mod forward_dynamics;
mod large;
mod regrouped;
mod states;
mod worst;
