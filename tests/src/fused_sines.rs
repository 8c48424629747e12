//! The runtime's sines and cosines as a target computes them that fuses products with sums.
//!
//! In: the runtime's own files, as they stand, over a product and a sum that are rounded once. Out: on every
//! machine, the bits that such a target has.

/// What the files take from beside them.
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
