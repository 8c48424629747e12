//! The change of frame, chosen by type.
//!
//! In: a matrix in frame (s) and M_r,s. Out: the same thing in frame (r). Kinematic matrices go by
//! M · M⁻¹, dynamic ones by M · Mᵗ, points by M ·; nobody has to remember which.

use crate::acceleration::Acceleration;
use crate::action::Action;
use crate::displacement::Displacement;
use crate::inertia::Inertia;
use crate::momentum::Momentum;
use crate::point::{Direction, Point};
use crate::pose::Pose;
use crate::scalar::Scalar;
use crate::screw::Screw;
use crate::vector::{add, cross, matrix_product, negate, outer, product, scale, sub, transpose};
use crate::velocity::Velocity;

/// What has components in a frame and can be written in another one.
///
/// Called through [`Pose::change_frame`].
pub trait Tensor<T> {
    /// The same thing in frame (r), given `m_r_s`, the pose of frame (s) in (r).
    #[must_use]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self;
}

impl<T: Scalar> Tensor<T> for Point<T> {
    /// P₍ᵣ₎ = Mᵣₛ P₍ₛ₎ (1).
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        Self(add(product(m_r_s.rotation(), self.0), m_r_s.translation()))
    }
}

impl<T: Scalar> Tensor<T> for Direction<T> {
    /// v₍ᵣ₎ = Rᵣₛ v₍ₛ₎ (§ 2.1).
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        Self(product(m_r_s.rotation(), self.0))
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

/// (u̲, b) ↦ M (u̲, b) M⁻¹ = (Ru, R b + t × Ru).
#[inline]
fn kinematic<T: Scalar>(m_r_s: &Pose<T>, u: [T; 3], b: [T; 3]) -> ([T; 3], [T; 3]) {
    let u = product(m_r_s.rotation(), u);
    let b = add(product(m_r_s.rotation(), b), cross(m_r_s.translation(), u));
    (u, b)
}

impl<T: Scalar> Tensor<T> for Screw<T> {
    /// L₍ᵣ₎ = Mᵣₛ L₍ₛ₎ Mᵣₛ⁻¹.
    ///
    /// SPACELIB: `trasf_mami`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (u, b) = kinematic(m_r_s, self.u(), self.b());
        Self::new(u, b)
    }
}

impl<T: Scalar> Tensor<T> for Velocity<T> {
    /// W₍ᵣ₎ = Mᵣₛ W₍ₛ₎ Mᵣₛ⁻¹ (8).
    ///
    /// SPACELIB: `trasf_mami`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (omega, v) = kinematic(m_r_s, self.omega(), self.v());
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

/// (c̲, f; −fᵗ, 0) ↦ M (…) Mᵗ = (Rc + t × Rf, Rf).
#[inline]
fn dynamic<T: Scalar>(m_r_s: &Pose<T>, c: [T; 3], f: [T; 3]) -> ([T; 3], [T; 3]) {
    let f = product(m_r_s.rotation(), f);
    let c = add(product(m_r_s.rotation(), c), cross(m_r_s.translation(), f));
    (c, f)
}

impl<T: Scalar> Tensor<T> for Momentum<T> {
    /// Γ₍ᵣ₎ = Mᵣₛ Γ₍ₛ₎ Mᵣₛᵗ (17).
    ///
    /// SPACELIB: `trasf_mamt`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (gamma, rho) = dynamic(m_r_s, self.gamma(), self.rho());
        Self::new(gamma, rho)
    }
}

impl<T: Scalar> Tensor<T> for Action<T> {
    /// Φ₍ᵣ₎ = Mᵣₛ Φ₍ₛ₎ Mᵣₛᵗ (17).
    ///
    /// SPACELIB: `trasf_mamt`.
    #[inline]
    fn in_frame(&self, m_r_s: &Pose<T>) -> Self {
        let (c, f) = dynamic(m_r_s, self.c(), self.f());
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

impl<T: Scalar> Pose<T> {
    /// M₁,₀ = M₀,₁⁻¹ = (Rᵗ, −Rᵗ t) (§ 2.2).
    ///
    /// SPACELIB: `invers`.
    #[inline]
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = transpose(self.rotation());
        Self::new(rotation, negate(product(&rotation, self.translation())))
    }
}
