//! The nearest rotation, pose, symmetric and skew-symmetric matrix.
//!
//! In: a matrix with errors, of many products or of the digits of a file. Out: the nearest matrix of the
//! form, in the Frobenius norm. Nothing else in this crate calls these functions.

use crate::error::{Error, finite};
use crate::matrix::Pose;
use crate::matrix::rotation::from_quaternion;
use crate::matrix::symmetric::eigen;
use crate::matrix::vector::{largest_magnitude, unit};
use crate::scalar::{Real, Scalar};
use core::array::from_fn;

/// The rotation nearest to `matrix` X, as rows: R with the least ‖R − X‖.
///
/// It is the eigenvector of the largest eigenvalue of Davenport's symmetric 4×4 matrix, read as a
/// quaternion; the result for a reflection is the nearest proper rotation.
///
/// SPACELIB: `normal`, `normal3`, `normal4`, for drifts of any size.
///
/// # Errors
///
/// [`Error::NotFinite`] for NaN and infinity; [`Error::Degenerate`] if two rotations are equally near, as for
/// the zero matrix.
pub fn nearest_rotation<T: Real>(matrix: &[[T; 3]; 3]) -> Result<[[T; 3]; 3], Error> {
    finite("an entry of R", matrix.iter().flatten())?;
    let zero = T::constant(0.0);
    let largest = largest_magnitude(matrix.as_flattened());
    let scale = if largest > zero {
        largest
    } else {
        T::constant(1.0)
    };
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = matrix.map(|row| row.map(|x| x / scale));
    // tr(R(q)ᵗ X) = qᵗ K q, so the best unit quaternion maximises it.
    let k = [
        [xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, yy - xx - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, zz - xx - yy],
    ];
    let (values, vectors) = eigen(&k);
    let gap = values[0] - values[1];
    if gap <= T::constant(16.0) * T::EPSILON {
        return Err(Error::Degenerate {
            quantity: "the gap between the two nearest rotations",
            value: gap.to_f64(),
        });
    }
    // After many small rotations the length differs from 1 by a few units of rounding.
    Ok(from_quaternion(unit(vectors[0]).unwrap_or(vectors[0])))
}

/// The pose whose rotation is nearest to that of `pose`, with the same translation.
///
/// SPACELIB: `normal`, `normal4`.
///
/// # Errors
///
/// As [`nearest_rotation`].
pub fn nearest_pose<T: Real>(pose: &Pose<T>) -> Result<Pose<T>, Error> {
    finite("an entry of t", &pose.translation())?;
    Ok(Pose::new(
        nearest_rotation(pose.rotation())?,
        pose.translation(),
    ))
}

/// ½(X + Xᵗ), the symmetric matrix nearest to X.
///
/// SPACELIB: `n_simm`, `n_simm3`, `n_simm34`, `n_simm4`, and `norm_simm_skew` with sign +1.
#[inline]
#[must_use]
pub fn nearest_symmetric<T: Scalar, const N: usize>(matrix: &[[T; N]; N]) -> [[T; N]; N] {
    from_fn(|i| from_fn(|j| T::constant(0.5) * (matrix[i][j] + matrix[j][i])))
}

/// ½(X − Xᵗ), the skew-symmetric matrix nearest to X.
///
/// SPACELIB: `n_skew`, `n_skew3`, `n_skew34`, `n_skew4`, and `norm_simm_skew` with sign −1.
#[inline]
#[must_use]
pub fn nearest_skew<T: Scalar, const N: usize>(matrix: &[[T; N]; N]) -> [[T; N]; N] {
    from_fn(|i| from_fn(|j| T::constant(0.5) * (matrix[i][j] - matrix[j][i])))
}

/// skew\[X\] = X − Xᵗ, the paper's operator, twice the skew-symmetric part (§ 4.6).
///
/// SPACELIB: `skew`.
#[inline]
#[must_use]
pub fn skew<T: Scalar, const N: usize>(matrix: &[[T; N]; N]) -> [[T; N]; N] {
    from_fn(|i| from_fn(|j| matrix[i][j] - matrix[j][i]))
}
