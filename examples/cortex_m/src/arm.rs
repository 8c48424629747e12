//! The generated file: `Arm`, a struct without fields, and its functions.

include!(concat!(env!("OUT_DIR"), "/arm.rs"));
