//! The runtime's sines and cosines on a target that fuses products with sums, and on one that does not.
//!
//! In: an angle \[rad\]. Out: the bits of such a target, on every machine.

/// Double precision.
pub mod double {
    use homogen::rounding::{Fused, Unfused};
    use homogen::trigonometry::double::sin_cos_by;

    /// Sine and cosine with fused products.
    #[must_use]
    pub fn sin_cos(angle: f64) -> (f64, f64) {
        sin_cos_by::<Fused>(angle)
    }

    /// Sine and cosine without fused products.
    #[must_use]
    pub fn unfused(angle: f64) -> (f64, f64) {
        sin_cos_by::<Unfused>(angle)
    }
}

/// Single precision.
pub mod single {
    use homogen::rounding::{Fused, Unfused};
    use homogen::trigonometry::single::sin_cos_by;

    /// Sine and cosine with fused products.
    #[must_use]
    pub fn sin_cos(angle: f32) -> (f32, f32) {
        sin_cos_by::<Fused>(angle)
    }

    /// Sine and cosine without fused products.
    #[must_use]
    pub fn unfused(angle: f32) -> (f32, f32) {
        sin_cos_by::<Unfused>(angle)
    }
}
