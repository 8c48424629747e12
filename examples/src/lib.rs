//! Shared by the examples: pictures, and nothing else.

pub mod plot;
