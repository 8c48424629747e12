//! 4×4 matrices with all their entries.
//!
//! In: sixteen numbers a matrix. Out: exponential, inverse, pseudo scalar product and blocks, each by
//! its formula in the paper, independently of the typed matrices.

use core::array::from_fn;
use nalgebra::{Matrix3, Matrix4, RealField};

/// exp(L φ) = I + L φ + L² (1 − cos φ) + L³ (φ − sin φ), the series of § 5 summed by u̲ⁿ⁺² = −u̲ⁿ.
///
/// 1 − cos φ is 2 sin²(φ/2), which keeps all its digits. The block u̲ φ + u̲³ (φ − sin φ) of the first
/// and last terms is u̲ sin φ, and is written so.
pub(super) fn exponential<T: RealField + Copy>(l: &Matrix4<T>, phi: T) -> Matrix4<T> {
    let (half, two): (T, T) = (nalgebra::convert(0.5), nalgebra::convert(2.0));
    let (sine, half_sine) = (phi.sin(), (half * phi).sin());
    let versine = two * half_sine * half_sine;
    let (square, cube) = (l * l, l * l * l);
    let rotation = Matrix4::identity() + l * sine + square * versine;
    let translation = l * phi + square * versine + cube * (phi - sine);
    let mut q = rotation;
    for i in 0..3 {
        q[(i, 3)] = translation[(i, 3)];
    }
    q
}

/// R = 1 + 2 w v̲ + 2 v̲² of a quaternion v, w of unit length, with no translation.
pub(super) fn turned<T: RealField + Copy>([x, y, z]: [T; 3], w: T) -> Matrix4<T> {
    let two: T = nalgebra::convert(2.0);
    let skew = Matrix3::new(T::zero(), -z, y, z, T::zero(), -x, -y, x, T::zero());
    (Matrix3::identity() + skew * (two * w) + skew * skew * two).to_homogeneous()
}

/// M⁻¹ = (Rᵗ, −Rᵗ t; 0, 1) (§ 2.2).
pub(super) fn inverse<T: RealField + Copy>(m: &Matrix4<T>) -> Matrix4<T> {
    let rotation = m.fixed_view::<3, 3>(0, 0).transpose();
    let translation = -(rotation * m.fixed_view::<3, 1>(0, 3));
    let mut inverse = rotation.to_homogeneous();
    inverse.fixed_view_mut::<3, 1>(0, 3).copy_from(&translation);
    inverse
}

/// L ⊗ Φ = u · c + b · f (Part II).
pub(super) fn pseudo_scalar_product<T: RealField + Copy>(l: &Matrix4<T>, phi: &Matrix4<T>) -> T {
    let (u, b, c, f) = (axial(l), column(l), axial(phi), column(phi));
    u[0] * c[0] + u[1] * c[1] + u[2] * c[2] + b[0] * f[0] + b[1] * f[1] + b[2] * f[2]
}

/// H_g, the acceleration of gravity in the last column (§ 4.5).
pub(super) fn gravity_matrix<T: RealField + Copy>(gravity: [f64; 3]) -> Matrix4<T> {
    let mut h_g = Matrix4::zeros();
    for (i, g) in gravity.into_iter().enumerate() {
        h_g[(i, 3)] = nalgebra::convert(g);
    }
    h_g
}

/// A constant 4×4 matrix, rounded to T.
pub(super) fn dense<T: RealField + Copy>(rows: [[f64; 4]; 4]) -> Matrix4<T> {
    Matrix4::from_fn(|i, j| nalgebra::convert(rows[i][j]))
}

/// The upper left block, as rows.
pub(super) fn block<T: RealField + Copy>(x: &Matrix4<T>) -> [[T; 3]; 3] {
    from_fn(|i| from_fn(|j| x[(i, j)]))
}

/// The upper three entries of the last column.
pub(super) fn column<T: RealField + Copy>(x: &Matrix4<T>) -> [T; 3] {
    from_fn(|i| x[(i, 3)])
}

/// The vector of the skew upper left block.
pub(super) fn axial<T: RealField + Copy>(x: &Matrix4<T>) -> [T; 3] {
    [x[(2, 1)], x[(0, 2)], x[(1, 0)]]
}
