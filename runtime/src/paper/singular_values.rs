//! Singular values of a small matrix with any number of rows and columns.
//!
//! In: rows, and a right-hand side. Out: the singular values, the rank, and the least-squares solution of
//! least norm, by one-sided Jacobi rotations (Hestenes 1958), which keep small singular values accurate.
//! Unlike the decomposition of nalgebra it needs neither allocation nor bounds on the generic sizes.

use crate::matrix::vector::largest_magnitude;
use crate::scalar::Real;
use core::array::from_fn;

/// A singular value counts as zero below this many units of ε times the largest one.
const TOLERANCE: f64 = 64.0;

/// Sweeps converge quadratically; six or seven are usual.
const SWEEPS: usize = 40;

/// The rank of the matrix with these rows, and the least-squares solution x of A x = y with the least norm.
/// Both arguments are overwritten.
///
/// The rank is the number of singular values above 64 ε times the largest.
pub(crate) fn solve<T: Real, const N: usize>(a: &mut [[T; N]], y: &mut [T]) -> (usize, [T; N]) {
    let scale = moderate(a);
    orthogonalize(a, y);
    let zero = T::constant(0.0);
    let squares = || a.iter().map(|row| dot(row, row));
    let largest = squares().fold(zero, T::max).sqrt();
    let threshold = T::constant(TOLERANCE) * T::EPSILON * largest;
    let mut rank = 0;
    let mut x = [zero; N];
    for ((row, y), square) in a.iter().zip(y.iter()).zip(squares()) {
        if square.sqrt() > threshold {
            rank += 1;
            let factor = *y / square;
            x = from_fn(|j| x[j] + factor * row[j]);
        }
    }
    (rank, x.map(|x| x / scale))
}

/// The singular values of the matrix with these rows, the largest first, and the rank: the number of those above
/// 64 ε times the largest. The argument is overwritten.
pub(crate) fn values<T: Real, const N: usize, const R: usize>(
    a: &mut [[T; N]; R],
) -> ([T; R], usize) {
    let zero = T::constant(0.0);
    let scale = moderate(a);
    orthogonalize(a, &mut [zero; R]);
    let mut values = from_fn(|i| scale * dot(&a[i], &a[i]).sqrt());
    for i in 1..R {
        let mut k = i;
        while k > 0 && values[k - 1] < values[k] {
            values.swap(k - 1, k);
            k -= 1;
        }
    }
    let largest = values.iter().fold(zero, |most, value| most.max(*value));
    let threshold = T::constant(TOLERANCE) * T::EPSILON * largest;
    let rank = values.iter().filter(|value| **value > threshold).count();
    (values, rank)
}

/// Divides a matrix by its largest entry if squares of that overflow or lose digits; returns the divisor.
fn moderate<T: Real, const N: usize>(a: &mut [[T; N]]) -> T {
    let largest = largest_magnitude(a.as_flattened());
    let square = largest * largest * T::constant(64.0);
    let is_moderate = square.is_finite() && square * T::EPSILON * T::EPSILON > T::MIN_POSITIVE;
    if is_moderate || largest <= T::constant(0.0) || !largest.is_finite() {
        return T::constant(1.0);
    }
    for entry in a.as_flattened_mut() {
        *entry = *entry / largest;
    }
    largest
}

/// Rotates pairs of rows, and the right-hand side with them, until all rows are orthogonal. The lengths of
/// the rows are the singular values.
fn orthogonalize<T: Real, const N: usize>(a: &mut [[T; N]], y: &mut [T]) {
    let (zero, one, two) = (T::constant(0.0), T::constant(1.0), T::constant(2.0));
    let largest = a.iter().map(|row| dot(row, row)).fold(zero, T::max);
    // The rest of a row that depends on others is rounding error without a meaningful direction.
    let noise = T::EPSILON * T::EPSILON * largest;
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for p in 0..a.len() {
            for q in p + 1..a.len() {
                let (alpha, beta) = (dot(&a[p], &a[p]), dot(&a[q], &a[q]));
                let gamma = dot(&a[p], &a[q]);
                let orthogonal = gamma.abs() <= T::EPSILON * alpha.sqrt() * beta.sqrt();
                if orthogonal || alpha <= noise || beta <= noise || !gamma.is_finite() {
                    continue;
                }
                rotated = true;
                let zeta = (beta - alpha) / (two * gamma);
                let root = (one + zeta * zeta).sqrt();
                let tangent = if zeta < zero {
                    one / (zeta - root)
                } else {
                    one / (zeta + root)
                };
                let cosine = one / (one + tangent * tangent).sqrt();
                let sine = cosine * tangent;
                let turn = |p: T, q: T| (cosine * p - sine * q, sine * p + cosine * q);
                let (row_p, row_q) = (a[p], a[q]);
                a[p] = from_fn(|j| turn(row_p[j], row_q[j]).0);
                a[q] = from_fn(|j| turn(row_p[j], row_q[j]).1);
                (y[p], y[q]) = turn(y[p], y[q]);
            }
        }
        if !rotated {
            break;
        }
    }
}

/// a · b, of any length.
pub(super) fn dot<T: Real, const N: usize>(a: &[T; N], b: &[T; N]) -> T {
    let products = a.iter().zip(b).map(|(a, b)| *a * *b);
    products.fold(T::constant(0.0), |sum, product| sum + product)
}

#[cfg(all(test, feature = "nalgebra"))]
mod tests {
    use super::{orthogonalize, solve, values};
    use core::array::from_fn;
    use homogen_random::Random;
    use nalgebra::{SMatrix, SVector};

    /// Pseudo-random entries in (−1, 1).
    fn entries<const R: usize, const N: usize>(seed: u64) -> [[f64; N]; R] {
        let mut random = Random::new(seed);
        from_fn(|_| from_fn(|_| random.odd()))
    }

    #[test]
    fn singular_values_agree_with_nalgebra() {
        for seed in 0..200 {
            let rows: [[f64; 7]; 6] = entries(seed);
            let reference = SMatrix::<f64, 6, 7>::from_fn(|i, j| rows[i][j]).singular_values();
            let mut ours = rows;
            orthogonalize(&mut ours, &mut [0.0; 6]);
            let mut lengths = ours.map(|row| row.iter().map(|x| x * x).sum::<f64>().sqrt());
            lengths.sort_by(|a, b| b.total_cmp(a));
            let (all, rank) = values(&mut rows.clone());
            assert_eq!((all, rank), (lengths, 6));
            for (length, value) in lengths.iter().zip(reference.iter()) {
                assert!(
                    (length - value).abs() < 1e-14,
                    "{lengths:?} but {reference}"
                );
            }
        }
    }

    #[test]
    fn more_rows_than_columns_are_solved_in_the_least_squares_sense() {
        for seed in 0..200 {
            let rows: [[f64; 3]; 6] = entries(seed);
            let [right]: [[f64; 6]; 1] = entries(seed + 1000);
            let matrix = SMatrix::<f64, 6, 3>::from_fn(|i, j| rows[i][j]);
            let reference = matrix
                .svd(true, true)
                .solve(&SVector::<f64, 6>::from(right), 1e-12)
                .expect("both factors were asked for");
            let (rank, x) = solve(&mut rows.clone(), &mut right.clone());
            assert_eq!(rank, 3);
            for (ours, theirs) in x.iter().zip(reference.iter()) {
                assert!((ours - theirs).abs() < 1e-12 * reference.norm().max(1.0));
            }
        }
    }

    #[test]
    fn neither_huge_nor_tiny_entries_lose_their_squares() {
        let rows: [[f64; 4]; 3] = entries(7);
        let right = [0.3, -0.2, 0.9];
        let (rank, x) = solve(&mut rows.clone(), &mut right.clone());
        let (expected, _) = values(&mut rows.clone());
        for scale in [1e200, 1e300, 1e-160, 1e-300] {
            let mut scaled = rows.map(|row| row.map(|entry| scale * entry));
            let (values, values_rank) = values(&mut scaled.clone());
            let (other_rank, y) = solve(&mut scaled, &mut right.clone());
            assert_eq!((other_rank, values_rank), (rank, rank));
            for (value, expected) in values.iter().zip(expected) {
                assert!((value / scale - expected).abs() < 1e-14, "{scale:e}");
            }
            for (x, y) in x.iter().zip(y) {
                assert!((y * scale - x).abs() < 1e-13, "{scale:e}");
            }
        }
    }

    #[test]
    fn rank_counts_what_is_not_rounding() {
        for seed in 0..200 {
            let [a, b]: [[f64; 5]; 2] = entries(seed);
            let mut rows: [[f64; 5]; 6] = from_fn(|i| {
                let (s, c) = (0.3 * f64::from(u8::try_from(i).expect("small"))).sin_cos();
                from_fn(|j| s * a[j] + c * b[j])
            });
            assert_eq!(solve(&mut rows, &mut [0.0; 6]).0, 2);
        }
        assert_eq!(
            solve(&mut [[0.0; 4]; 6], &mut [1.0; 6]),
            (0, [0.0; 4]),
            "a zero matrix"
        );
    }
}
