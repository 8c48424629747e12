//! H, the acceleration matrix.
//!
//! In: its blocks, or angular acceleration, angular velocity and the acceleration of the reference
//! point (the paper's pole). Out: the acceleration of every point of a body, and the composition of
//! relative motions with the Coriolis term. Two H alone have no sum: it needs the velocities too.

use super::form::kinematic_matrix;
use super::point::{Direction, Point};
use super::vector::{
    add, axial, cross, matrix_product, matrix_scale, matrix_sum, product, scale, sub, transpose,
    underscore,
};
use super::velocity::Velocity;
use crate::scalar::Scalar;
use core::ops::Mul;

/// The acceleration matrix Hᵢⱼ₍ₖ₎ = (G, a₀; 0, 0) of body j relative to body i, in frame (k)
/// (§ 3.1, (7)).
///
/// G = ω̲̇ + ω̲² [rad/s²], and a₀ is the acceleration [m/s²] of the pole: the point of the body that
/// is now at the origin of (k). H = Ẇ + W². It is not the spatial acceleration of Featherstone,
/// which is Ẇ ([`velocity_derivative`](Self::velocity_derivative)).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Acceleration<T> {
    g: [[T; 3]; 3],
    a: [T; 3],
}

impl<T> Acceleration<T> {
    /// (G, a₀; 0, 0), G as rows; nothing is checked.
    #[inline]
    #[must_use]
    pub const fn new(g: [[T; 3]; 3], a: [T; 3]) -> Self {
        Self { g, a }
    }

    /// G = ω̲̇ + ω̲² [rad/s²], as rows.
    #[inline]
    #[must_use]
    pub const fn g(&self) -> &[[T; 3]; 3] {
        &self.g
    }
}

impl<T: Copy> Acceleration<T> {
    /// a₀, the acceleration of the pole [m/s²].
    #[inline]
    #[must_use]
    pub const fn a(&self) -> [T; 3] {
        self.a
    }
}

impl<T: Scalar> Acceleration<T> {
    /// No acceleration.
    #[inline]
    #[must_use]
    pub fn zero() -> Self {
        let zero = T::constant(0.0);
        Self::new([[zero; 3]; 3], [zero; 3])
    }

    /// H from ω̇ [rad/s²], ω [rad/s] and the acceleration of the pole [m/s²] (§ 3.1).
    #[inline]
    #[must_use]
    pub fn from_parts(omega_dot: [T; 3], omega: [T; 3], a: [T; 3]) -> Self {
        let [x, y, z] = omega;
        let (xx, yy, zz) = (x * x, y * y, z * z);
        let (xy, xz, yz) = (x * y, x * z, y * z);
        let [p, q, r] = omega_dot;
        Self::new(
            [
                [-(yy + zz), xy - r, xz + q],
                [xy + r, -(xx + zz), yz - p],
                [xz - q, yz + p, -(xx + yy)],
            ],
            a,
        )
    }

    /// H from ω̇, ω and the acceleration [m/s²] of the point of the body at `point` \[m\].
    ///
    /// SPACELIB: `velacctoWH`.
    #[inline]
    #[must_use]
    pub fn at_point(omega_dot: [T; 3], omega: [T; 3], acceleration: [T; 3], point: [T; 3]) -> Self {
        let h = Self::from_parts(omega_dot, omega, acceleration);
        Self::new(h.g, sub(acceleration, product(&h.g, point)))
    }

    /// H = Ẇ + W² (§ 3.1), from W and the blocks ω̇ and v̇₀ of its derivative `w_dot`.
    #[inline]
    #[must_use]
    pub fn from_velocity_derivative(w: &Velocity<T>, w_dot: &Velocity<T>) -> Self {
        Self::from_parts(
            w_dot.omega(),
            w.omega(),
            add(w_dot.v(), cross(w.omega(), w.v())),
        )
    }

    /// Ẇ = H − W² (§ 3.1): its blocks are ω̇ [rad/s²] and v̇₀ [m/s²].
    #[inline]
    #[must_use]
    pub fn velocity_derivative(&self, w: &Velocity<T>) -> Velocity<T> {
        Velocity::new(self.omega_dot(), sub(self.a, cross(w.omega(), w.v())))
    }

    /// H_g, which holds the acceleration of gravity [m/s²] in its last column (§ 4.5).
    ///
    /// SPACELIB: `gtom`.
    #[inline]
    #[must_use]
    pub fn gravity(g: [T; 3]) -> Self {
        Self::new([[T::constant(0.0); 3]; 3], g)
    }

    /// ω̇ of ω̲̇ = ½(G − Gᵗ) [rad/s²] (§ 3.1).
    ///
    /// SPACELIB: `Gtomegapto`.
    #[inline]
    #[must_use]
    pub fn omega_dot(&self) -> [T; 3] {
        axial(&self.g)
    }

    /// ω̲² = ½(G + Gᵗ) [rad²/s²], as rows (§ 3.1).
    #[inline]
    #[must_use]
    pub fn omega_squared(&self) -> [[T; 3]; 3] {
        matrix_scale(T::constant(0.5), &matrix_sum(&self.g, &transpose(&self.g)))
    }

    /// Hᵢₖ = Hᵢⱼ + Hⱼₖ + 2 Wᵢⱼ Wⱼₖ, all in one frame (11), (13).
    ///
    /// `self` is Hᵢⱼ, the drag part; the last term is the Coriolis term.
    ///
    /// SPACELIB: `coriolis`.
    #[inline]
    #[must_use]
    pub fn compose(&self, h_j_k: &Self, w_i_j: &Velocity<T>, w_j_k: &Velocity<T>) -> Self {
        let coriolis = Self::coriolis(w_i_j, w_j_k);
        Self::new(
            matrix_sum(&matrix_sum(&self.g, &h_j_k.g), &coriolis.g),
            add(add(self.a, h_j_k.a), coriolis.a),
        )
    }

    /// 2 Wᵢⱼ Wⱼₖ, the Coriolis term of Hᵢₖ (11).
    ///
    /// SPACELIB: `coriolis`.
    #[inline]
    #[must_use]
    pub fn coriolis(w_i_j: &Velocity<T>, w_j_k: &Velocity<T>) -> Self {
        let two = T::constant(2.0);
        let square = matrix_product(&underscore(w_i_j.omega()), &underscore(w_j_k.omega()));
        Self::new(
            matrix_scale(two, &square),
            scale(two, cross(w_i_j.omega(), w_j_k.v())),
        )
    }

    /// H − H_g: multiplied by the inertia it gives the wrench that must be applied besides the weight
    /// (§ 4.5).
    #[inline]
    #[must_use]
    pub fn less_gravity(&self, g: [T; 3]) -> Self {
        Self::new(self.g, sub(self.a, g))
    }

    /// The 4×4 matrix (G, a₀; 0, 0), as rows.
    #[inline]
    #[must_use]
    pub fn to_matrix(&self) -> [[T; 4]; 4] {
        kinematic_matrix(&self.g, self.a)
    }
}

impl<T: Scalar> Mul<Point<T>> for Acceleration<T> {
    type Output = Direction<T>;

    /// P̈ = H P = a₀ + ω̇ × P + ω × (ω × P) [m/s²] (7).
    #[inline]
    fn mul(self, point: Point<T>) -> Direction<T> {
        Direction(add(product(&self.g, point.0), self.a))
    }
}

impl<T: Scalar> Mul<Direction<T>> for Acceleration<T> {
    type Output = Direction<T>;

    /// The second rate G v of a vector that is fixed in the body.
    #[inline]
    fn mul(self, direction: Direction<T>) -> Direction<T> {
        Direction(product(&self.g, direction.0))
    }
}
