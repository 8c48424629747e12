//! L, the screw axis matrix, and the finite motion exp(L φ).
//!
//! In: an axis, a point and a pitch, or Plücker coordinates. Out: the unit twist of a joint or of an
//! instantaneous screw axis, and its finite displacements. [`Displacement::log`] is the inverse: the screw
//! of a displacement.

use super::acceleration::Acceleration;
use super::action::Action;
use super::displacement::Displacement;
use super::form::kinematic_matrix;
use super::point::{Direction, Point};
use super::vector::{add, cross, dot, matrix_scale, negate, outer, scale, underscore};
use super::velocity::Velocity;
use crate::scalar::Scalar;
use core::ops::{Mul, Neg};

/// The screw L = (u̲, b; 0, 0), a unit twist: the motion at one unit of the rate of its coordinate φ (§ 5).
///
/// | pair | u | b |
/// |---|---|---|
/// | revolute, screw | unit vector of the axis | −u̲ p_ax + p u [m/rad], p_ax a point of the axis, p the pitch [m/rad] |
/// | prismatic | 0 | unit vector of the direction |
///
/// The six numbers are the Plücker coordinates of the axis. The pole (reference point) is the origin of the
/// frame in which L is written.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Screw<T> {
    u: [T; 3],
    b: [T; 3],
}

impl<T> Screw<T> {
    /// The screw (u̲, b; 0, 0); nothing is checked, so that it can be a constant.
    #[inline]
    #[must_use]
    pub const fn new(u: [T; 3], b: [T; 3]) -> Self {
        Self { u, b }
    }
}

impl<T: Copy> Screw<T> {
    /// u, the unit vector of the axis; zero for a translation.
    #[inline]
    #[must_use]
    pub const fn u(&self) -> [T; 3] {
        self.u
    }

    /// b, the motion of the pole by one unit of φ.
    #[inline]
    #[must_use]
    pub const fn b(&self) -> [T; 3] {
        self.b
    }
}

impl<T: Scalar> Screw<T> {
    /// A revolute pair about the unit vector `axis` through `point` \[m\]: (u̲, −u̲ p_ax) (§ 5, and
    /// Part II).
    ///
    /// SPACELIB: `makeL`.
    #[inline]
    #[must_use]
    pub fn revolute(axis: [T; 3], point: [T; 3]) -> Self {
        Self::new(axis, negate(cross(axis, point)))
    }

    /// A prismatic pair along the unit vector `direction`: (0, u) (Part II).
    ///
    /// SPACELIB: `makeL`.
    #[inline]
    #[must_use]
    pub fn prismatic(direction: [T; 3]) -> Self {
        Self::new([T::constant(0.0); 3], direction)
    }

    /// A screw pair about the unit vector `axis` through `point` \[m\] with `pitch` [m/rad]:
    /// (u̲, −u̲ p_ax + p u) (§ 5, and Part II).
    ///
    /// SPACELIB: `makeL`, `makeL2`.
    #[inline]
    #[must_use]
    pub fn helical(axis: [T; 3], point: [T; 3], pitch: T) -> Self {
        Self::new(axis, add(negate(cross(axis, point)), scale(pitch, axis)))
    }

    /// The pitch p = u · b (m/rad) of a screw with a unit vector u; 0 for a translation, whose pitch is
    /// infinite (§ 5).
    #[inline]
    #[must_use]
    pub fn pitch(&self) -> T {
        dot(self.u(), self.b())
    }

    /// p_ax = u × b (m), the point of the axis that is nearest to the origin, of a screw with a unit
    /// vector u; the origin for a translation, whose axis has no position (§ 5).
    #[inline]
    #[must_use]
    pub fn axis_point(&self) -> [T; 3] {
        cross(self.u(), self.b())
    }

    /// W = L φ̇, the velocity of a body that moves along the screw at `rate` (§ 5, and Part II).
    #[inline]
    #[must_use]
    pub fn velocity(&self, rate: T) -> Velocity<T> {
        Velocity::new(scale(rate, self.u), scale(rate, self.b))
    }

    /// H = L φ̈ + L² φ̇², the acceleration along a fixed screw (Part II).
    #[inline]
    #[must_use]
    pub fn acceleration(&self, rate: T, second_rate: T) -> Acceleration<T> {
        let w = self.velocity(rate);
        Acceleration::from_velocity_derivative(&w, &self.velocity(second_rate))
    }

    /// L P, the derivative dP/dφ of a point that moves along the screw (§ 5).
    #[inline]
    #[must_use]
    pub fn derivative(&self, point: Point<T>) -> Direction<T> {
        Direction(add(cross(self.u, point.0), self.b))
    }

    /// Q(φ) = exp(L φ), the motion along the screw by `phi` [rad, or m for a translation] (§ 5).
    ///
    /// u must be a unit vector or zero. One formula holds for all pairs and every φ:
    /// R = I + u̲ sin φ + u̲² (1 − cos φ) and t = b φ + u × b (1 − cos φ) + u × (u × b) (φ − sin φ),
    /// with 1 − cos φ as 2 sin²(φ/2) and φ − sin φ by [`Scalar::minus_sine`], so that small angles lose
    /// no digits.
    ///
    /// SPACELIB: `screwtom`, `rotat`, `rotat2`, `rotat24`, `rotat34`, `traslat`.
    ///
    /// ```
    /// use homogen::{Point, Screw};
    /// let quarter = core::f64::consts::FRAC_PI_2;
    /// let hinge = Screw::revolute([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]);
    /// let moved = hinge.exp(quarter) * Point([2.0, 0.0, 0.0]);
    /// assert!((moved - Point([1.0, 1.0, 0.0])).0.iter().all(|x: &f64| x.abs() < 1e-15));
    /// ```
    #[inline]
    #[must_use]
    pub fn exp(&self, phi: T) -> Displacement<T> {
        let one = T::constant(1.0);
        let (u, b) = (self.u, self.b);
        let (sine, _) = phi.sin_cos();
        let (half_sine, _) = (T::constant(0.5) * phi).sin_cos();
        let versine = T::constant(2.0) * half_sine * half_sine;
        let [x, y, z] = scale(sine, u);
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = matrix_scale(versine, &outer(u, u));
        let rotation = [
            [one - (yy + zz), xy - z, xz + y],
            [xy + z, one - (xx + zz), yz - x],
            [xz - y, yz + x, one - (xx + yy)],
        ];
        let across = cross(u, b);
        let turn = add(
            scale(versine, across),
            scale(phi.minus_sine(sine), cross(u, across)),
        );
        Displacement::new(rotation, add(scale(phi, b), turn))
    }

    /// L ⊗ Φ = u · c + b · f, the pseudo scalar product: the power of the wrench `action` at unit rate, which
    /// is the torque or force of the joint (Part II).
    ///
    /// SPACELIB: `psedot`.
    #[inline]
    #[must_use]
    pub fn pseudo_scalar_product(&self, action: &Action<T>) -> T {
        dot(self.u, action.c()) + dot(self.b, action.f())
    }

    /// The 4×4 matrix (u̲, b; 0, 0), as rows.
    #[inline]
    #[must_use]
    pub fn to_matrix(&self) -> [[T; 4]; 4] {
        kinematic_matrix(&underscore(self.u), self.b)
    }
}

impl<T: Scalar> Mul<Point<T>> for Screw<T> {
    type Output = Direction<T>;

    /// dP/dφ = L P (§ 5).
    #[inline]
    fn mul(self, point: Point<T>) -> Direction<T> {
        self.derivative(point)
    }
}

impl<T: Scalar> Neg for Screw<T> {
    type Output = Self;

    /// The same axis in the opposite direction.
    #[inline]
    fn neg(self) -> Self {
        Self::new(negate(self.u), negate(self.b))
    }
}
