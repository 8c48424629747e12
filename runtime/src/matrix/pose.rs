//! M, the position matrix.
//!
//! In: a rotation and a translation. Out: the pose of frame (j) in frame (i), its inverse, and its
//! products with poses, points and directions. Nothing is orthogonalised; [`crate::normalize`] does that.

use super::point::{Direction, Point};
use super::vector::{add, identity, matrix_product, negate, product, transpose};
use crate::scalar::Scalar;
use core::ops::Mul;

/// The position matrix Mᵢⱼ = (R, t; 0, 1): the pose of frame (j) in frame (i) (§ 2.2, (1)).
///
/// Translations are in metres. `M_i_j` maps coordinates in (j) to coordinates in (i).
///
/// ```
/// use homogen::{Point, Pose};
/// let m_0_1 = Pose::new([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [0.5, 0.0, 0.0]);
/// assert_eq!(m_0_1 * Point([1.0, 0.0, 0.0]), Point([0.5, 1.0, 0.0]));
/// assert_eq!(m_0_1 * m_0_1.inverse(), Pose::identity());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pose<T> {
    rotation: [[T; 3]; 3],
    translation: [T; 3],
}

impl<T> Pose<T> {
    /// The pose with the rows `rotation` of Rᵢⱼ and tᵢⱼ = `translation` \[m\].
    ///
    /// Nothing is checked, so that it can be a constant.
    #[inline]
    #[must_use]
    pub const fn new(rotation: [[T; 3]; 3], translation: [T; 3]) -> Self {
        Self {
            rotation,
            translation,
        }
    }

    /// Rᵢⱼ, as rows; column k is axis k of frame (j) in frame (i).
    #[inline]
    #[must_use]
    pub const fn rotation(&self) -> &[[T; 3]; 3] {
        &self.rotation
    }
}

impl<T: Copy> Pose<T> {
    /// tᵢⱼ, the origin of frame (j) in frame (i) \[m\].
    #[inline]
    #[must_use]
    pub const fn translation(&self) -> [T; 3] {
        self.translation
    }
}

impl<T: Scalar> Pose<T> {
    /// Mᵢᵢ.
    #[inline]
    #[must_use]
    pub fn identity() -> Self {
        Self::new(identity(), [T::constant(0.0); 3])
    }

    /// A frame with parallel axes, its origin at `translation` \[m\].
    ///
    /// SPACELIB: `traslat`, `traslat2`, `traslat24`.
    #[inline]
    #[must_use]
    pub fn from_translation(translation: [T; 3]) -> Self {
        Self::new(identity(), translation)
    }

    /// M₁,₀ = M₀,₁⁻¹ = (Rᵗ, −Rᵗ t) (§ 2.2).
    ///
    /// SPACELIB: `invers`.
    #[inline]
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = transpose(self.rotation());
        Self::new(rotation, negate(product(&rotation, self.translation())))
    }

    /// The 4×4 matrix (R, t; 0 0 0 1), as rows.
    #[inline]
    #[must_use]
    pub fn to_matrix(&self) -> [[T; 4]; 4] {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.rotation;
        let [x, y, z] = self.translation;
        [
            [xx, xy, xz, x],
            [yx, yy, yz, y],
            [zx, zy, zz, z],
            [zero, zero, zero, one],
        ]
    }
}

impl<T: Scalar> Mul for Pose<T> {
    type Output = Self;

    /// Mᵢₖ = Mᵢⱼ Mⱼₖ (§ 2.2).
    #[inline]
    fn mul(self, m_j_k: Self) -> Self {
        Self::new(
            matrix_product(&self.rotation, &m_j_k.rotation),
            add(product(&self.rotation, m_j_k.translation), self.translation),
        )
    }
}

impl<T: Scalar> Mul<Point<T>> for Pose<T> {
    type Output = Point<T>;

    /// P₍ᵢ₎ = Mᵢⱼ P₍ⱼ₎ (1).
    #[inline]
    fn mul(self, point: Point<T>) -> Point<T> {
        Point(add(product(&self.rotation, point.0), self.translation))
    }
}

impl<T: Scalar> Mul<Direction<T>> for Pose<T> {
    type Output = Direction<T>;

    /// v₍ᵢ₎ = Rᵢⱼ v₍ⱼ₎ (§ 2.1).
    #[inline]
    fn mul(self, direction: Direction<T>) -> Direction<T> {
        Direction(product(&self.rotation, direction.0))
    }
}
