//! Γ, the momentum matrix.
//!
//! In: an angular and a linear momentum. Out: their 4×4 matrix, which adds to other momenta only.
//! [`crate::Inertia::momentum`] makes it from W and J.

use super::form::dynamic_matrix;
use super::vector::{add, cross, negate, scale, sub};
use crate::scalar::Scalar;
use core::ops::{Add, Neg, Sub};

/// The momentum matrix Γᵢ₍ₖ₎ = (γ̲, ρ; −ρᵗ, 0) (§ 4.2, (15)).
///
/// γ is the angular momentum about the origin of frame (k) [kg m²/s], ρ the linear momentum
/// [kg m/s].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Momentum<T> {
    gamma: [T; 3],
    rho: [T; 3],
}

impl<T> Momentum<T> {
    /// (γ̲, ρ; −ρᵗ, 0), in kg m²/s and kg m/s.
    #[inline]
    #[must_use]
    pub const fn new(gamma: [T; 3], rho: [T; 3]) -> Self {
        Self { gamma, rho }
    }
}

impl<T: Copy> Momentum<T> {
    /// γ, the angular momentum about the origin of the frame [kg m²/s].
    #[inline]
    #[must_use]
    pub const fn gamma(&self) -> [T; 3] {
        self.gamma
    }

    /// ρ, the linear momentum [kg m/s].
    #[inline]
    #[must_use]
    pub const fn rho(&self) -> [T; 3] {
        self.rho
    }
}

impl<T: Scalar> Momentum<T> {
    /// No momentum.
    #[inline]
    #[must_use]
    pub fn zero() -> Self {
        Self::new([T::constant(0.0); 3], [T::constant(0.0); 3])
    }

    /// (Ṗ Pᵗ − P Ṗᵗ) dm, the momentum of a particle: the integrand of Γ (§ 4.2).
    #[inline]
    #[must_use]
    pub fn of_particle(mass: T, position: [T; 3], velocity: [T; 3]) -> Self {
        let rho = scale(mass, velocity);
        Self::new(cross(position, rho), rho)
    }

    /// The 4×4 matrix (γ̲, ρ; −ρᵗ, 0), as rows.
    #[inline]
    #[must_use]
    pub fn to_matrix(&self) -> [[T; 4]; 4] {
        dynamic_matrix(self.gamma, self.rho)
    }
}

impl<T: Scalar> Add for Momentum<T> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(add(self.gamma, other.gamma), add(self.rho, other.rho))
    }
}

impl<T: Scalar> Sub for Momentum<T> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(sub(self.gamma, other.gamma), sub(self.rho, other.rho))
    }
}

impl<T: Scalar> Neg for Momentum<T> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(negate(self.gamma), negate(self.rho))
    }
}
