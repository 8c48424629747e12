//! Jacobians: arrays of screws, one column a joint.
//!
//! In: `[Screw<T>; N]`. Out: the 6×N matrix, angular or linear rows first as the method's name says, and the
//! velocity at given rates.

use crate::matrix::{Screw, Velocity};
use crate::scalar::Scalar;
use core::array::from_fn;

/// Operations on a Jacobian, an array of columns.
///
/// Axes and reference point are those of the function that computed it; see [`crate::robot`].
pub trait Jacobian<T, const N: usize> {
    /// The rows u_x, u_y, u_z, b_x, b_y, b_z.
    #[must_use]
    fn to_matrix_angular_first(&self) -> [[T; N]; 6];

    /// The rows b_x, b_y, b_z, u_x, u_y, u_z.
    #[must_use]
    fn to_matrix_linear_first(&self) -> [[T; N]; 6];

    /// W = Σ Lᵢ q̇ᵢ, with the axes and the reference point of the Jacobian (12).
    #[must_use]
    fn velocity(&self, qd: &[T; N]) -> Velocity<T>;
}

impl<T: Scalar, const N: usize> Jacobian<T, N> for [Screw<T>; N] {
    #[inline]
    fn to_matrix_angular_first(&self) -> [[T; N]; 6] {
        let [bx, by, bz, ux, uy, uz] = self.to_matrix_linear_first();
        [ux, uy, uz, bx, by, bz]
    }

    #[inline]
    fn to_matrix_linear_first(&self) -> [[T; N]; 6] {
        let row = |entry: fn(&Screw<T>) -> T| from_fn(|i| entry(&self[i]));
        [
            row(|l| l.b()[0]),
            row(|l| l.b()[1]),
            row(|l| l.b()[2]),
            row(|l| l.u()[0]),
            row(|l| l.u()[1]),
            row(|l| l.u()[2]),
        ]
    }

    #[inline]
    fn velocity(&self, qd: &[T; N]) -> Velocity<T> {
        self.iter()
            .zip(qd)
            .fold(Velocity::zero(), |w, (l, rate)| w + l.velocity(*rate))
    }
}
