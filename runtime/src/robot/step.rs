//! Steps of a whole robot: from a posture by velocities, and from one posture to another.
//!
//! In: a [`Chain`], coordinates, and velocities times a duration. Out: coordinates, or velocities times a
//! duration. How a joint goes is said by its [`Motion`]; what is not an angle or a shift is left to
//! [`posture`]. It knows no forces.

use super::chain::Chain;
use super::joint::Motion;
use super::posture;
use crate::scalar::Scalar;

impl<const N: usize, const F: usize, const Q: usize, const B: usize> Chain<N, F, Q, B> {
    /// The coordinates at which every joint that does not follow another is at its placement: zeros, and 0, 0,
    /// 0, 1 of quaternions.
    #[must_use]
    pub fn neutral<T: Scalar>(&self) -> [T; Q] {
        let mut q = [T::constant(0.0); Q];
        self.each_quaternion(&mut q, |_| [0.0, 0.0, 0.0, 1.0].map(T::constant));
        q
    }

    /// Where the robot gets to from `q` if it keeps its velocities for one unit of time; of a time Δt, `v` is
    /// q̇ Δt.
    ///
    /// Coordinates along screws are added to. Bodies whose velocities are seen in their own frame move along
    /// the screw that they keep, exp(W Δt): the chain is where it should be to rounding, however far it goes.
    /// Quaternions keep their length 1: an error of it is squared.
    ///
    /// ```
    /// use homogen::{Chain, Inertia, Joint, Pose};
    /// let body = Inertia::of_particle(1.0, [0.0; 3]);
    /// let free: Chain<6, 0, 7, 1> = Chain::new(
    ///     [Joint::floating("body", None, Pose::new(homogen::vector::identity(), [0.0; 3]), body)],
    ///     [],
    ///     [0.0; 3],
    /// );
    /// // A quarter of a circle about z, forwards along its tangent: of radius 1.
    /// let quarter = core::f64::consts::FRAC_PI_2;
    /// let motion = [quarter, 0.0, 0.0, 0.0, 0.0, quarter];
    /// let there = free.integrate(&free.neutral(), &motion);
    /// assert!((there[0] - 1.0).abs() < 1e-15 && (there[1] - 1.0).abs() < 1e-15);
    /// let found: [f64; 6] = free.difference(&free.neutral(), &there);
    /// assert!((0..6).all(|k| (found[k] - motion[k]).abs() < 1e-15));
    /// ```
    #[must_use]
    pub fn integrate<T: Scalar>(&self, q: &[T; Q], v: &[T; N]) -> [T; Q] {
        let mut moved = *q;
        for (i, joint) in self.joints.iter().enumerate() {
            let (own, rates) = (self.coordinates(i), self.velocities(i));
            let (Some(q), Some(v)) = (moved.get_mut(own), v.get(rates)) else {
                continue;
            };
            match joint.motion {
                Motion::Along => step(q, v, |[q], [v]| [q + v]),
                Motion::Following { .. } => {}
                Motion::Planar => step(q, v, posture::integrate_planar),
                Motion::Spherical => step(q, v, posture::integrate_spherical),
                Motion::Floating => step(q, v, posture::integrate_floating),
            }
        }
        moved
    }

    /// The velocities that lead from `from` to `to` in one unit of time: what [`integrate`](Self::integrate)
    /// needs.
    ///
    /// Turns of bodies whose velocities are seen in their own frame are the shortest, of half a circle at
    /// most (of exactly half a circle either of the two); coordinates along screws are subtracted.
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
                Motion::Following { .. } => {}
                Motion::Planar => compare(v, from, to, posture::difference_planar),
                Motion::Spherical => compare(v, from, to, posture::difference_spherical),
                Motion::Floating => compare(v, from, to, posture::difference_floating),
            }
        }
        v
    }

    /// The same coordinates with quaternions of length 1, to rounding, whatever their lengths. One that is zero, or has
    /// an entry that is not finite, comes out as NaN.
    #[must_use]
    pub fn normalize<T: Scalar>(&self, q: &[T; Q]) -> [T; Q] {
        let mut normalized = *q;
        self.each_quaternion(&mut normalized, posture::normalized);
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

/// Moves the coordinates of a joint, where they are as many as they should be.
fn step<T: Copy, const Q: usize, const N: usize>(
    q: &mut [T],
    v: &[T],
    integrate: impl Fn([T; Q], [T; N]) -> [T; Q],
) {
    if let (Ok(q), Ok(v)) = (<&mut [T; Q]>::try_from(q), <[T; N]>::try_from(v)) {
        *q = integrate(*q, v);
    }
}

/// Compares the coordinates of a joint, where they are as many as they should be.
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
