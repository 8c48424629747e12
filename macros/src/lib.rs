//! The doors for the compiler.
