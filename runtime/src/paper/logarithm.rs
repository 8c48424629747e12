//! The logarithm of a displacement, and the instantaneous screw axis of a velocity.
//!
//! In: a displacement Q, or a velocity W. Out: its screw L with the motion φ or the rate φ̇ along it, the
//! inverse of exp and of L φ̇; the displacement at a constant W. Accurate near 0 and near π, without NaN at
//! rest and in pure translation, where the axis is at infinity.

use crate::matrix::rotation::HalfAngle;
use crate::matrix::vector::{add, cross, dot, norm, scale, sub, unit};
use crate::matrix::{Displacement, Screw, Velocity};
use crate::scalar::Real;

impl<T: Real> Displacement<T> {
    /// The screw L and the motion φ in \[0, π\] rad along it with Q = exp(L φ) (§ 2.3, § 5).
    ///
    /// For a pure translation L is (0, u) and φ its length (m); for the identity φ = 0 and L is a screw
    /// along z. At φ = π the axis is either of the two opposite ones. R is not checked.
    ///
    /// With the quaternion's cot(φ/2) = w/‖v‖, b = u (u·t)/φ + ½ cot(φ/2) t⊥ − ½ u × t⊥.
    ///
    /// SPACELIB: `mtoscrew`, `extract`.
    ///
    /// ```
    /// use homogen::Screw;
    /// let screw = Screw::helical([0.0, 0.0, 1.0], [1.0, 2.0, 0.0], 0.25);
    /// let (found, phi) = screw.exp(3.0).log();
    /// assert!((phi - 3.0_f64).abs() < 1e-15);
    /// assert!((found.pitch() - 0.25).abs() < 1e-15);
    /// assert!((found.axis_point()[1] - 2.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn log(&self) -> (Screw<T>, T) {
        let (zero, half) = (T::constant(0.0), T::constant(0.5));
        let t = self.translation();
        let turn = HalfAngle::of_rotation(self.rotation());
        let (u, phi) = (turn.axis, turn.angle());
        if phi > zero {
            let along = dot(u, t);
            let across = sub(t, scale(along, u));
            let radial = scale(half * turn.cosine / turn.sine, across);
            let tangential = scale(half, cross(u, across));
            let b = add(scale(along / phi, u), sub(radial, tangential));
            if b.iter().all(|x| x.is_finite()) {
                return (Screw::new(u, b), phi);
            }
        }
        // No rotation, or one so small that its axis lies beyond the largest number.
        match unit(t) {
            Some(direction) => (Screw::prismatic(direction), norm(t)),
            None => (Screw::new(u, [zero; 3]), zero),
        }
    }
}

impl<T: Real> Velocity<T> {
    /// The instantaneous screw axis L with the rate φ̇ ≥ 0 along it: W = L φ̇ (§ 5).
    ///
    /// φ̇ = ‖ω‖ (rad/s), or ‖v₀‖ (m/s) if ω = 0; at rest φ̇ = 0 and L is zero. There is no threshold: as ω
    /// goes to zero the axis goes to infinity, until its position overflows.
    ///
    /// SPACELIB: `WtoL`.
    ///
    /// ```
    /// use homogen::{Screw, Velocity};
    /// let (axis, rate) = Velocity::new([0.0, 0.0, 2.0], [0.0, -2.0, 1.0]).instantaneous_screw_axis();
    /// assert_eq!((axis.axis_point(), axis.pitch(), rate), ([1.0, 0.0, 0.0], 0.5, 2.0));
    /// let (at_rest, rate) = Velocity::<f64>::zero().instantaneous_screw_axis();
    /// assert_eq!((at_rest, rate), (Screw::new([0.0; 3], [0.0; 3]), 0.0));
    /// ```
    #[must_use]
    pub fn instantaneous_screw_axis(&self) -> (Screw<T>, T) {
        let zero = T::constant(0.0);
        if let Some(u) = unit(self.omega()) {
            let rate = norm(self.omega());
            let b = self.v().map(|v| v / rate);
            if b.iter().all(|x| x.is_finite()) {
                return (Screw::new(u, b), rate);
            }
        }
        match unit(self.v()) {
            Some(direction) => (Screw::prismatic(direction), norm(self.v())),
            None => (Screw::new([zero; 3], [zero; 3]), zero),
        }
    }

    /// exp(W Δt), the displacement of a body at constant velocity for `duration` (s).
    ///
    /// To first order it is the infinitesimal motion dP = W P dt (§ 5).
    #[must_use]
    pub fn displacement(&self, duration: T) -> Displacement<T> {
        let (screw, rate) = self.instantaneous_screw_axis();
        screw.exp(rate * duration)
    }
}
