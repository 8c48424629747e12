//! Rounding of a product and a sum.
//!
//! In: two factors and a term. Out: `factor · other + term`, rounded once or twice: a type for each choice, by which
//! code is generic over it.
#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the processor that was found"
)]

use super::Scalar;

/// Rounding of `factor · other + term`.
pub trait Rounding: Sized {
    /// True if product and sum are rounded once.
    const FUSES: bool;

    /// `factor · other + term` in double precision.
    #[must_use]
    fn f64(factor: f64, other: f64, term: f64) -> f64;

    /// `factor · other + term` in single precision.
    #[must_use]
    fn f32(factor: f32, other: f32, term: f32) -> f32;

    /// `factor · other + term` of any number.
    #[inline(always)]
    #[must_use]
    fn mul_add<T: Scalar>(factor: T, other: T, term: T) -> T {
        factor.mul_add_by::<Self>(other, term)
    }

    /// The sines and the cosines of all angles \[rad\] of any number.
    #[inline(always)]
    #[must_use]
    fn sin_cos_all<T: Scalar, const N: usize>(angles: [T; N]) -> ([T; N], [T; N]) {
        T::sin_cos_all_by::<Self, N>(angles)
    }
}

/// Rounded once if the target has the instruction and the feature `std` gives access to it, otherwise twice.
///
/// It is never a call of a library routine.
#[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
pub type OfTarget = Fused;

/// Rounded once if the target has the instruction and the feature `std` gives access to it, otherwise twice.
///
/// It is never a call of a library routine.
#[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
pub type OfTarget = Unfused;

/// Rounded once on every target: where the compiled code lacks the instruction, by a library routine.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub enum Fused {}

/// Rounded twice on every target: the product, then the sum.
#[derive(Clone, Copy, Debug)]
pub enum Unfused {}

#[cfg(feature = "std")]
impl Rounding for Fused {
    const FUSES: bool = true;

    #[inline(always)]
    fn f64(factor: f64, other: f64, term: f64) -> f64 {
        factor.mul_add(other, term)
    }

    #[inline(always)]
    fn f32(factor: f32, other: f32, term: f32) -> f32 {
        factor.mul_add(other, term)
    }
}

impl Rounding for Unfused {
    const FUSES: bool = false;

    #[inline(always)]
    fn f64(factor: f64, other: f64, term: f64) -> f64 {
        factor * other + term
    }

    #[inline(always)]
    fn f32(factor: f32, other: f32, term: f32) -> f32 {
        factor * other + term
    }
}
