//! Eigenvalues and eigenvectors of a small symmetric matrix.
//!
//! In: N×N rows; the upper triangle is read. Out: eigenvalues in descending order with orthonormal
//! eigenvectors, by Jacobi's cyclic rotations: simple, slow, accurate to rounding for every input. The
//! number of sweeps is bounded.

use crate::scalar::Real;
use core::array::from_fn;

/// Eigenvalues in descending order, and the unit eigenvector of each.
///
/// Source: C. G. J. Jacobi 1846; the rotation by the smaller angle as in Golub and Van Loan, § 8.5.
pub(crate) fn eigen<T: Real, const N: usize>(matrix: &[[T; N]; N]) -> ([T; N], [[T; N]; N]) {
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    // The upper triangle is copied to the lower one.
    let mut a = from_fn(|i: usize| from_fn(|j: usize| matrix[i.min(j)][i.max(j)]));
    let mut vectors = from_fn(|i| from_fn(|j| if i == j { one } else { zero }));
    // Convergence is quadratic; more than eight sweeps have never been needed for N ≤ 4.
    for _ in 0..32 {
        let mut rotated = false;
        for p in 0..N {
            for q in p + 1..N {
                rotated |= rotate(&mut a, &mut vectors, p, q);
            }
        }
        if !rotated {
            break;
        }
    }
    let mut order = from_fn::<usize, N, _>(|i| i);
    for i in 1..N {
        for j in (1..=i).rev() {
            if a[order[j]][order[j]] > a[order[j - 1]][order[j - 1]] {
                order.swap(j, j - 1);
            }
        }
    }
    (order.map(|i| a[i][i]), order.map(|i| vectors[i]))
}

/// One rotation in the plane of axes p and q; false if the entry is already negligible.
fn rotate<T: Real, const N: usize>(
    a: &mut [[T; N]; N],
    vectors: &mut [[T; N]; N],
    p: usize,
    q: usize,
) -> bool {
    let (zero, one, two) = (T::constant(0.0), T::constant(1.0), T::constant(2.0));
    let (app, aqq, apq) = (a[p][p], a[q][q], a[p][q]);
    // The entry is below the rounding of the diagonal.
    let scale = app.abs().max(aqq.abs());
    if apq == zero || !apq.is_finite() || scale + apq.abs() * T::constant(0.01) == scale {
        return false;
    }
    let theta = (aqq - app) / (two * apq);
    let sign = if theta < zero { -one } else { one };
    let tangent = if (theta * theta).is_finite() {
        sign / (theta.abs() + (theta * theta + one).sqrt())
    } else {
        one / (two * theta)
    };
    let cosine = one / (tangent * tangent + one).sqrt();
    let sine = tangent * cosine;
    a[p][p] = app - tangent * apq;
    a[q][q] = aqq + tangent * apq;
    a[p][q] = zero;
    a[q][p] = zero;
    for k in 0..N {
        if k != p && k != q {
            let (akp, akq) = (a[k][p], a[k][q]);
            a[k][p] = cosine * akp - sine * akq;
            a[k][q] = sine * akp + cosine * akq;
            a[p][k] = a[k][p];
            a[q][k] = a[k][q];
        }
        let (vp, vq) = (vectors[p][k], vectors[q][k]);
        vectors[p][k] = cosine * vp - sine * vq;
        vectors[q][k] = sine * vp + cosine * vq;
    }
    true
}
