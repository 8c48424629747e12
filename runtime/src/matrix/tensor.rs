//! The change of frame of each type.
//!
//! In: a matrix in frame (s) and M_r,s. Out: the same quantity in frame (r): M · M⁻¹ for kinematic matrices,
//! M · Mᵗ for dynamic ones, M · for points.

use super::acceleration::Acceleration;
use super::action::Action;
use super::displacement::Displacement;
use super::form::{dynamic_in_frame, kinematic_in_frame};
use super::inertia::Inertia;
use super::momentum::Momentum;
use super::point::{Direction, Point};
use super::pose::Pose;
use super::screw::Screw;
use super::vector::{add, matrix_product, outer, product, scale, sub, transpose};
use super::velocity::Velocity;
use crate::scalar::Scalar;

/// A quantity with components in a frame, which can be written in another one.
///
/// Called through [`Pose::change_frame`].
pub trait Tensor<T> {
    /// The same quantity in frame (r), with `m_r_s` the pose of frame (s) in (r).
    #[must_use]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self;
}

impl<T: Scalar> Pose<T> {
    /// The same quantity in frame (r), where `self` is M_r,s and `x` is in frame (s).
    ///
    /// Kinematic matrices change by M · M⁻¹ ((8), (9)), dynamic ones by M · Mᵗ (17), points by M · (1).
    ///
    /// SPACELIB: `trasf_mami`, `trasf_mamt`; its `trasf_miam` and `trasf_miamit` are the same with
    /// [`Pose::inverse`].
    ///
    /// ```
    /// use homogen::{Pose, Velocity};
    /// let m_0_1 = Pose::from_translation([1.0, 0.0, 0.0]);
    /// // A body that rotates about the z axis of frame (1).
    /// let w_in_1 = Velocity::new([0.0, 0.0, 2.0], [0.0, 0.0, 0.0]);
    /// assert_eq!(m_0_1.change_frame(&w_in_1), Velocity::new([0.0, 0.0, 2.0], [0.0, -2.0, 0.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn change_frame<X: Tensor<T>>(&self, x: &X) -> X {
        x.in_frame(self)
    }
}

impl<T: Scalar> Tensor<T> for Point<T> {
    /// P₍ᵣ₎ = Mᵣₛ P₍ₛ₎ (1).
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        *m_r_s * *self
    }
}

impl<T: Scalar> Tensor<T> for Direction<T> {
    /// v₍ᵣ₎ = Rᵣₛ v₍ₛ₎ (§ 2.1).
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        *m_r_s * *self
    }
}

impl<T: Scalar> Tensor<T> for Displacement<T> {
    /// Q₍ᵣ₎ = Mᵣₛ Q₍ₛ₎ Mᵣₛ⁻¹ (after (5)).
    ///
    /// SPACELIB: `trasf_mami`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let r = m_r_s.rotation();
        let rotation = matrix_product(&matrix_product(r, self.rotation()), &transpose(r));
        let moved = add(product(r, self.translation()), m_r_s.translation());
        Self::new(
            rotation,
            sub(moved, product(&rotation, m_r_s.translation())),
        )
    }
}

impl<T: Scalar> Tensor<T> for Screw<T> {
    /// L₍ᵣ₎ = Mᵣₛ L₍ₛ₎ Mᵣₛ⁻¹.
    ///
    /// SPACELIB: `trasf_mami`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (u, b) = kinematic_in_frame(m_r_s, self.u(), self.b());
        Self::new(u, b)
    }
}

impl<T: Scalar> Tensor<T> for Velocity<T> {
    /// W₍ᵣ₎ = Mᵣₛ W₍ₛ₎ Mᵣₛ⁻¹ (8).
    ///
    /// SPACELIB: `trasf_mami`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (omega, v) = kinematic_in_frame(m_r_s, self.omega(), self.v());
        Self::new(omega, v)
    }
}

impl<T: Scalar> Tensor<T> for Acceleration<T> {
    /// H₍ᵣ₎ = Mᵣₛ H₍ₛ₎ Mᵣₛ⁻¹ (9).
    ///
    /// SPACELIB: `trasf_mami`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let r = m_r_s.rotation();
        let g = matrix_product(&matrix_product(r, self.g()), &transpose(r));
        Self::new(
            g,
            sub(product(r, self.a()), product(&g, m_r_s.translation())),
        )
    }
}

impl<T: Scalar> Tensor<T> for Momentum<T> {
    /// Γ₍ᵣ₎ = Mᵣₛ Γ₍ₛ₎ Mᵣₛᵗ (17).
    ///
    /// SPACELIB: `trasf_mamt`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (gamma, rho) = dynamic_in_frame(m_r_s, self.gamma(), self.rho());
        Self::new(gamma, rho)
    }
}

impl<T: Scalar> Tensor<T> for Action<T> {
    /// Φ₍ᵣ₎ = Mᵣₛ Φ₍ₛ₎ Mᵣₛᵗ (17).
    ///
    /// SPACELIB: `trasf_mamt`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (c, f) = dynamic_in_frame(m_r_s, self.c(), self.f());
        Self::new(c, f)
    }
}

impl<T: Scalar> Tensor<T> for Inertia<T> {
    /// J₍ᵣ₎ = Mᵣₛ J₍ₛ₎ Mᵣₛᵗ (17): R J Rᵗ + (Rq) tᵗ + t (Rq)ᵗ + m t tᵗ, R q + m t, m.
    ///
    /// SPACELIB: `trasf_mamt`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (r, t) = (m_r_s.rotation(), m_r_s.translation());
        let turned = matrix_product(&matrix_product(r, &self.second_moments()), &transpose(r));
        let q = product(r, self.q());
        // (Rq + m t) tᵗ + t (Rq)ᵗ holds every term once.
        let moved = add(q, scale(self.mass(), t));
        let (left, right) = (outer(moved, t), outer(t, q));
        let entry = |i: usize, j: usize| turned[i][j] + left[i][j] + right[i][j];
        Self::new(
            [
                entry(0, 0),
                entry(1, 1),
                entry(2, 2),
                entry(0, 1),
                entry(0, 2),
                entry(1, 2),
            ],
            moved,
            self.mass(),
        )
    }
}

impl<T: Scalar> Tensor<T> for Pose<T> {
    /// Mᵣₖ = Mᵣₛ Mₛₖ (after (1)).
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        *m_r_s * *self
    }
}
