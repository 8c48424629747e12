//! The runtime's sines and cosines on a target that fuses products with sums.
//!
//! In: the runtime's own files, over a multiply-add that rounds once. Out: the bits of such a target, on every machine.

/// The module that the files import.
mod fused {
    pub fn f32(factor: f32, other: f32, term: f32) -> f32 {
        factor.mul_add(other, term)
    }

    pub fn f64(factor: f64, other: f64, term: f64) -> f64 {
        factor.mul_add(other, term)
    }
}

#[path = "../../runtime/src/scalar/trigonometry/double.rs"]
pub mod double;
#[path = "../../runtime/src/scalar/trigonometry/single.rs"]
pub mod single;
