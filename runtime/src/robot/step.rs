//! Integration and difference of configurations of a whole robot, and normalised quaternions.
//!
//! In: a [`Chain`] or the motions of its joints, coordinates, and velocities times a duration. Out: coordinates, or
//! velocities times a duration. [`manifold`] has the same for planar, spherical and floating joints alone.

use core::ops::Range;

use super::chain::Chain;
use super::joint::Motion;
use super::manifold;
use crate::scalar::Scalar;

impl<const N: usize, const F: usize, const Q: usize, const B: usize> Chain<N, F, Q, B> {
    /// The neutral configuration, with every joint at its placement: zeros, and 0, 0, 0, 1 for quaternions.
    #[must_use]
    pub fn neutral<T: Scalar>(&self) -> [T; Q] {
        let mut q = [T::constant(0.0); Q];
        self.each_quaternion(&mut q, |_| [0.0, 0.0, 0.0, 1.0].map(T::constant));
        q
    }

    /// The configuration after a step `v` = q̇ Δt from `q` at constant velocities.
    ///
    /// Coordinates along screws are sums. Planar, spherical and floating joints, whose velocities are in the
    /// frame of the moved body, move along a constant screw, exp(W Δt): exact to rounding for steps of any size.
    /// Quaternions stay at length 1; an error of the length is squared.
    ///
    /// ```
    /// use homogen::{Chain, Inertia, Joint, Pose};
    /// let body = Inertia::of_particle(1.0, [0.0; 3]);
    /// let free: Chain<6, 0, 7, 1> = Chain::new(
    ///     [Joint::floating("body", None, Pose::new(homogen::vector::identity(), [0.0; 3]), body)],
    ///     [],
    ///     [0.0; 3],
    /// );
    /// // A quarter of a circle of radius 1 about z, forwards along its tangent.
    /// let quarter = core::f64::consts::FRAC_PI_2;
    /// let motion = [quarter, 0.0, 0.0, 0.0, 0.0, quarter];
    /// let there = free.integrate(&free.neutral(), &motion);
    /// assert!((there[0] - 1.0).abs() < 1e-15 && (there[1] - 1.0).abs() < 1e-15);
    /// let found: [f64; 6] = free.difference(&free.neutral(), &there);
    /// assert!((0..6).all(|k| (found[k] - motion[k]).abs() < 1e-15));
    /// ```
    #[must_use]
    pub fn integrate<T: Scalar>(&self, q: &[T; Q], v: &[T; N]) -> [T; Q] {
        integrate(self.joints.iter().map(|joint| joint.motion), q, v)
    }

    /// The step q̇ Δt from `from` to `to`: the inverse of [`integrate`](Self::integrate).
    ///
    /// Coordinates along screws are differences. Planar, spherical and floating joints rotate the shortest way, by
    /// 180° at most; at exactly 180° either of the two ways is returned.
    #[must_use]
    pub fn difference<T: Scalar>(&self, from: &[T; Q], to: &[T; Q]) -> [T; N] {
        let mut v = [T::constant(0.0); N];
        for (i, joint) in self.joints.iter().enumerate() {
            let (own, rates) = (self.coordinates(i), self.velocities(i));
            let (Some(from), Some(to)) = (from.get(own.clone()), to.get(own)) else {
                continue;
            };
            let Some(v) = v.get_mut(rates) else { continue };
            match joint.motion {
                Motion::Along => compare(v, from, to, |[from], [to]| [to - from]),
                Motion::Mimic { .. } => {}
                Motion::Planar => compare(v, from, to, manifold::difference_planar),
                Motion::Spherical => compare(v, from, to, manifold::difference_spherical),
                Motion::Floating => compare(v, from, to, manifold::difference_floating),
            }
        }
        v
    }

    /// The same coordinates with quaternions of length 1, to rounding, from any length. A quaternion that is zero or
    /// has an entry that is not finite becomes NaN.
    #[must_use]
    pub fn normalize<T: Scalar>(&self, q: &[T; Q]) -> [T; Q] {
        let mut normalized = *q;
        self.each_quaternion(&mut normalized, manifold::normalized);
        normalized
    }

    /// Changes each quaternion of the coordinates.
    fn each_quaternion<T: Scalar>(&self, q: &mut [T; Q], change: impl Fn([T; 4]) -> [T; 4]) {
        for (i, joint) in self.joints.iter().enumerate() {
            if matches!(joint.motion, Motion::Spherical | Motion::Floating) {
                let own = q.get_mut(self.coordinates(i));
                if let Some(quaternion) = own.and_then(<[T]>::last_chunk_mut) {
                    *quaternion = change(*quaternion);
                }
            }
        }
    }
}

/// The configuration of joints with these motions after a step `v` from `q`.
pub(crate) fn integrate<T: Scalar, const N: usize, const Q: usize>(
    motions: impl Iterator<Item = Motion>,
    q: &[T; Q],
    v: &[T; N],
) -> [T; Q] {
    let mut moved = *q;
    for (motion, own, rates) in ranges(motions) {
        let (Some(q), Some(v)) = (moved.get_mut(own), v.get(rates)) else {
            continue;
        };
        match motion {
            Motion::Along => step(q, v, |[q], [v]| [q + v]),
            Motion::Mimic { .. } => {}
            Motion::Planar => step(q, v, manifold::integrate_planar),
            Motion::Spherical => step(q, v, manifold::integrate_spherical),
            Motion::Floating => step(q, v, manifold::integrate_floating),
        }
    }
    moved
}

/// Each motion with the indices of its coordinates and of its velocities.
pub(crate) fn ranges(
    motions: impl Iterator<Item = Motion>,
) -> impl Iterator<Item = (Motion, Range<usize>, Range<usize>)> {
    motions.scan((0, 0), |(coordinate, velocity), motion| {
        let own = *coordinate..*coordinate + motion.coordinates();
        let rates = *velocity..*velocity + motion.velocities();
        (*coordinate, *velocity) = (own.end, rates.end);
        Some((motion, own, rates))
    })
}

/// Applies `integrate` to the coordinates of a joint, if the lengths match.
fn step<T: Copy, const Q: usize, const N: usize>(
    q: &mut [T],
    v: &[T],
    integrate: impl Fn([T; Q], [T; N]) -> [T; Q],
) {
    if let (Ok(q), Ok(v)) = (<&mut [T; Q]>::try_from(q), <[T; N]>::try_from(v)) {
        *q = integrate(*q, v);
    }
}

/// Applies `difference` to the coordinates of a joint, if the lengths match.
fn compare<T: Copy, const Q: usize, const N: usize>(
    v: &mut [T],
    from: &[T],
    to: &[T],
    difference: impl Fn([T; Q], [T; Q]) -> [T; N],
) {
    let v = <&mut [T; N]>::try_from(v);
    if let (Ok(v), Ok(from), Ok(to)) = (v, <[T; Q]>::try_from(from), <[T; Q]>::try_from(to)) {
        *v = difference(from, to);
    }
}
