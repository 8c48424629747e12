//! The same arm for any type of number, with the chain for the generic recursions.
#![allow(missing_docs, clippy::pedantic, reason = "generated code")]

include!(concat!(env!("OUT_DIR"), "/arm.rs"));
