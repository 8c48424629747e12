//! Test of a symmetric matrix for positive definiteness.
//!
//! In: a matrix of `f64`. Out: its smallest pivot, with rounding errors and without a bound.

/// The smallest pivot of the Cholesky decomposition, positive if the matrix is positive definite.
#[must_use]
pub fn least_pivot<const N: usize>(mut matrix: [[f64; N]; N]) -> f64 {
    let mut least = f64::INFINITY;
    for k in 0..N {
        let (above, below) = matrix.split_at_mut(k + 1);
        let (row, pivot) = (above[k], above[k][k]);
        least = least.min(pivot);
        for other in below {
            let factor = other[k] / pivot;
            for (entry, x) in other.iter_mut().zip(row) {
                *entry -= factor * x;
            }
        }
    }
    least
}
