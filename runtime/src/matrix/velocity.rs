//! W, the velocity matrix.
//!
//! In: an angular velocity and the velocity of the reference point (the paper's pole). Out: the velocity
//! of every point of a body, and the composition of relative motions.
//! [`Velocity::instantaneous_screw_axis`] gives the screw axis of W.

use super::action::Action;
use super::form::kinematic_matrix;
use super::momentum::Momentum;
use super::point::{Direction, Point};
use super::vector::{add, cross, dot, negate, sub, underscore};
use crate::scalar::Scalar;
use core::ops::{Add, Mul, Neg, Sub};

/// The velocity matrix Wᵢⱼ₍ₖ₎ = (ω̲, v₀; 0, 0) of body j relative to body i, in frame (k)
/// (§ 3.1, (6)).
///
/// ω is the angular velocity [rad/s] and v₀ the velocity [m/s] of the pole: the point of the body
/// that is now at the origin of (k).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Velocity<T> {
    omega: [T; 3],
    v: [T; 3],
}

impl<T> Velocity<T> {
    /// (ω̲, v₀; 0, 0), in rad/s and m/s.
    #[inline]
    #[must_use]
    pub const fn new(omega: [T; 3], v: [T; 3]) -> Self {
        Self { omega, v }
    }
}

impl<T: Copy> Velocity<T> {
    /// ω, the angular velocity [rad/s].
    #[inline]
    #[must_use]
    pub const fn omega(&self) -> [T; 3] {
        self.omega
    }

    /// v₀, the velocity of the pole [m/s].
    #[inline]
    #[must_use]
    pub const fn v(&self) -> [T; 3] {
        self.v
    }
}

impl<T: Scalar> Velocity<T> {
    /// Rest.
    #[inline]
    #[must_use]
    pub fn zero() -> Self {
        Self::new([T::constant(0.0); 3], [T::constant(0.0); 3])
    }

    /// The velocity of a body with angular velocity `omega` [rad/s] whose point at `point` \[m\] has the
    /// velocity `velocity` [m/s].
    ///
    /// SPACELIB: `velacctoWH`.
    #[inline]
    #[must_use]
    pub fn at_point(omega: [T; 3], velocity: [T; 3], point: [T; 3]) -> Self {
        Self::new(omega, sub(velocity, cross(omega, point)))
    }

    /// The power \[W\] of `action` on the body: W ⊗ Φ = ω · c + v₀ · f, both in one frame.
    ///
    /// SPACELIB: `psedot`.
    #[inline]
    #[must_use]
    pub fn power(&self, action: &Action<T>) -> T {
        dot(self.omega, action.c()) + dot(self.v, action.f())
    }

    /// W ⊗ Γ = ω · γ + v₀ · ρ \[J\]: twice the kinetic energy when Γ is the momentum of W.
    ///
    /// SPACELIB: `psedot`.
    #[inline]
    #[must_use]
    pub fn pseudo_scalar_product(&self, momentum: &Momentum<T>) -> T {
        dot(self.omega, momentum.gamma()) + dot(self.v, momentum.rho())
    }

    /// The 4×4 matrix (ω̲, v₀; 0, 0), as rows.
    #[inline]
    #[must_use]
    pub fn to_matrix(&self) -> [[T; 4]; 4] {
        kinematic_matrix(&underscore(self.omega), self.v)
    }
}

impl<T: Scalar> Add for Velocity<T> {
    type Output = Self;

    /// Wᵢₖ = Wᵢⱼ + Wⱼₖ, all in one frame (10), (12).
    #[inline]
    fn add(self, w_j_k: Self) -> Self {
        Self::new(add(self.omega, w_j_k.omega), add(self.v, w_j_k.v))
    }
}

impl<T: Scalar> Sub for Velocity<T> {
    type Output = Self;

    /// Wᵢⱼ = Wᵢₖ − Wⱼₖ, all in one frame (12).
    #[inline]
    fn sub(self, w_j_k: Self) -> Self {
        Self::new(sub(self.omega, w_j_k.omega), sub(self.v, w_j_k.v))
    }
}

impl<T: Scalar> Neg for Velocity<T> {
    type Output = Self;

    /// Wⱼᵢ = −Wᵢⱼ.
    #[inline]
    fn neg(self) -> Self {
        Self::new(negate(self.omega), negate(self.v))
    }
}

impl<T: Scalar> Mul<Point<T>> for Velocity<T> {
    type Output = Direction<T>;

    /// Ṗ = W P = v₀ + ω × P [m/s] (6).
    ///
    /// SPACELIB: `Wtovel`.
    #[inline]
    fn mul(self, point: Point<T>) -> Direction<T> {
        Direction(add(self.v, cross(self.omega, point.0)))
    }
}

impl<T: Scalar> Mul<Direction<T>> for Velocity<T> {
    type Output = Direction<T>;

    /// The rate ω × v of a vector that is fixed in the body.
    #[inline]
    fn mul(self, direction: Direction<T>) -> Direction<T> {
        Direction(cross(self.omega, direction.0))
    }
}
