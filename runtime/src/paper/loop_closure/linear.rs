//! A x = y for the unknown joints, with the driving joints given.
//!
//! In: the matrix A, the size of the robot, and the given rates. Out: rank and solution. Lengths are divided
//! by the size of the robot, so that neither depends on the unit of length.

use super::found::Rates;
use crate::paper::singular_values::{self, dot};
use crate::scalar::Real;
use core::array::from_fn;

/// A x = y with lengths divided by the size of the robot.
pub(super) struct Linear<T, const N: usize, const K: usize> {
    /// All columns of A.
    all: [[[T; N]; 6]; K],
    /// The columns of the unknown joints; the others are zero.
    sought: [[[T; N]; 6]; K],
    /// Number of unknown joints.
    pub(super) number_sought: usize,
    size: T,
}

impl<T: Real, const N: usize, const K: usize> Linear<T, N, K> {
    /// `matrix` and `size` in the same unit of length; `driving` holds the given joints.
    pub(super) fn new(matrix: [[[T; N]; 6]; K], size: T, driving: &[Option<T>; N]) -> Self {
        let all = matrix.map(|[ux, uy, uz, bx, by, bz]| {
            let [bx, by, bz] = [bx, by, bz].map(|row| row.map(|x| x / size));
            [ux, uy, uz, bx, by, bz]
        });
        let zero = T::constant(0.0);
        let sought = all.map(|rows| {
            rows.map(|row| from_fn(|i| if driving[i].is_some() { zero } else { row[i] }))
        });
        Self {
            all,
            sought,
            number_sought: driving.iter().filter(|given| given.is_none()).count(),
            size,
        }
    }

    /// Rank and least-squares solution of the unknown columns, for a right-hand side with lengths in metres.
    pub(super) fn solve(&self, right: [[T; 6]; K]) -> (usize, [T; N]) {
        let (mut a, mut y) = (
            self.sought,
            right.map(|y| with_lengths_in_parts_of(self.size, y)),
        );
        singular_values::solve(a.as_flattened_mut(), y.as_flattened_mut())
    }

    /// The rates of all joints: the unknown ones so that A q̇ = `right` together with the `driving` ones.
    pub(super) fn rates(&self, right: [[T; 6]; K], driving: &[Option<T>; N]) -> Rates<T, N> {
        let zero = T::constant(0.0);
        let given: [T; N] = from_fn(|i| driving[i].unwrap_or(zero));
        let right = right.map(|y| with_lengths_in_parts_of(self.size, y));
        let mut y: [[T; 6]; K] =
            from_fn(|k| from_fn(|row| right[k][row] - dot(&self.all[k][row], &given)));
        let mut a = self.sought;
        let (rank, x) = singular_values::solve(a.as_flattened_mut(), y.as_flattened_mut());
        let values = from_fn(|i| driving[i].unwrap_or(x[i]));
        let rows = self.all.as_flattened().iter().zip(right.as_flattened());
        let residual = rows.fold(zero, |largest, (row, y)| {
            largest.max((dot(row, &values) - *y).abs())
        });
        Rates {
            values,
            rank,
            sought: self.number_sought,
            residual,
        }
    }
}

/// The six components with the lower three divided by a length.
pub(super) fn with_lengths_in_parts_of<T: Real>(
    size: T,
    [ux, uy, uz, bx, by, bz]: [T; 6],
) -> [T; 6] {
    [ux, uy, uz, bx / size, by / size, bz / size]
}
