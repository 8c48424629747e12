//! Denavit–Hartenberg parameters.
//!
//! In: θ, d, a and α of a link, in either of the two conventions in use. Out: the pose of its frame in
//! that of the previous link. The convention of a table must be known; the numbers do not show it.

use crate::matrix::Pose;
use crate::scalar::Scalar;

/// The four Denavit–Hartenberg parameters of a link.
///
/// Source: J. Denavit and R. S. Hartenberg, J. Appl. Mech. 22 (1955).
///
/// SPACELIB: `dhtom`, `DHtoMstd`.
///
/// ```
/// use homogen::denavit_hartenberg::Parameters;
/// // A horizontal link of 0.4 m, its joint 0.1 m above the previous one.
/// let link = Parameters { theta: 0.0, d: 0.1, a: 0.4, alpha: 0.0 };
/// assert_eq!(link.standard().translation(), [0.4, 0.0, 0.1]);
/// assert_eq!(link.standard(), link.modified());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<T> {
    /// θ, the rotation about z (rad): the coordinate of a revolute pair.
    pub theta: T,
    /// d, the translation along z (m): the coordinate of a prismatic pair.
    pub d: T,
    /// a, the translation along x (m).
    pub a: T,
    /// α, the rotation about x (rad).
    pub alpha: T,
}

impl<T: Scalar> Parameters<T> {
    /// Rot_z(θ) Trans_z(d) Trans_x(a) Rot_x(α), the original or standard convention: the frame of a
    /// link sits at its far joint.
    ///
    /// SPACELIB: `DHtoMstd`.
    #[inline]
    #[must_use]
    pub fn standard(&self) -> Pose<T> {
        let ([st, sa], [ct, ca]) = T::sin_cos_all([self.theta, self.alpha]);
        Pose::new(
            [
                [ct, -(st * ca), st * sa],
                [st, ct * ca, -(ct * sa)],
                [T::constant(0.0), sa, ca],
            ],
            [self.a * ct, self.a * st, self.d],
        )
    }

    /// Rot_x(α) Trans_x(a) Rot_z(θ) Trans_z(d), Craig's or the modified convention: the frame of a link
    /// sits at its near joint, and a and α are those of the previous link.
    ///
    /// SPACELIB: `dhtom`.
    #[inline]
    #[must_use]
    pub fn modified(&self) -> Pose<T> {
        let ([st, sa], [ct, ca]) = T::sin_cos_all([self.theta, self.alpha]);
        Pose::new(
            [
                [ct, -st, T::constant(0.0)],
                [st * ca, ct * ca, -sa],
                [st * sa, ct * sa, ca],
            ],
            [self.a, -(sa * self.d), ca * self.d],
        )
    }
}
