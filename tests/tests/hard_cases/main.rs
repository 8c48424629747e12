//! Chains and states that are hard on arithmetic, each by its name, with its limit.
//!
//! In: robots of [`homogen_tests::subjects`], seeded states. Out: errors in units of rounding against
//! 256 bits, in double and in single precision, fused and not, and in single precision without subnormal
//! numbers. A limit is the same whether products are fused with sums or not: that saves roundings, and
//! median errors are 5 % smaller. Every sixth state stands still, and every sixth creeps with subnormal
//! rates. Arguments are exact in every type; numbers of the robot are exact in the 256 bits, so that
//! rounding them to the type is part of the error. Limits are the figure aimed at where it was known
//! beforehand, and otherwise about twice what was measured; each says so.

mod angles;
mod cancelling;
mod case;
mod forward_dynamics;
mod large;
mod regrouped;
mod states;
mod worst;
