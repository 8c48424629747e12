//! Rigid bodies with 4x4 matrices.
#![no_std]
