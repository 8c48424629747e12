//! The two forms of matrix: kinematic, of L, W and H, and dynamic, of Γ and Φ.
//!
//! In: blocks, and M_r,s. Out: the sixteen entries, and the blocks in frame (r). The typed matrices use
//! these functions.

use super::pose::Pose;
use super::vector::{add, cross, product, underscore};
use crate::scalar::Scalar;

/// (X, x; 0, 0), as rows: the form of L, W and H.
#[inline]
pub(super) fn kinematic_matrix<T: Scalar>(block: &[[T; 3]; 3], column: [T; 3]) -> [[T; 4]; 4] {
    let zero = T::constant(0.0);
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *block;
    let [x, y, z] = column;
    [[xx, xy, xz, x], [yx, yy, yz, y], [zx, zy, zz, z], [zero; 4]]
}

/// (x̲, y; −yᵗ, 0), as rows: the form of Φ and Γ.
#[inline]
pub(super) fn dynamic_matrix<T: Scalar>(about: [T; 3], along: [T; 3]) -> [[T; 4]; 4] {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = underscore(about);
    let [x, y, z] = along;
    [
        [xx, xy, xz, x],
        [yx, yy, yz, y],
        [zx, zy, zz, z],
        [-x, -y, -z, T::constant(0.0)],
    ]
}

/// (u̲, b) ↦ M (u̲, b) M⁻¹ = (Ru, R b + t × Ru).
#[inline]
pub(super) fn kinematic_in_frame<T: Scalar>(
    m_r_s: &Pose<T>,
    u: [T; 3],
    b: [T; 3],
) -> ([T; 3], [T; 3]) {
    let u = product(m_r_s.rotation(), u);
    let b = add(product(m_r_s.rotation(), b), cross(m_r_s.translation(), u));
    (u, b)
}

/// (c̲, f; −fᵗ, 0) ↦ M (…) Mᵗ = (Rc + t × Rf, Rf).
#[inline]
pub(super) fn dynamic_in_frame<T: Scalar>(
    m_r_s: &Pose<T>,
    c: [T; 3],
    f: [T; 3],
) -> ([T; 3], [T; 3]) {
    let f = product(m_r_s.rotation(), f);
    let c = add(product(m_r_s.rotation(), c), cross(m_r_s.translation(), f));
    (c, f)
}
