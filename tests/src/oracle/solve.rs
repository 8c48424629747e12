//! Linear equations in 256 bits, by Gaussian elimination with partial pivoting.
//!
//! In: a square matrix and right-hand sides. Out: the solutions, to about 2⁻²⁵⁶ times the condition number. Symmetry
//! and sparsity are not used, unlike in the code under test.

use crate::big::Big;

/// X of A X = B, all row by row.
///
/// # Panics
/// If A is singular.
#[must_use]
pub fn solve(mut a: Vec<Vec<Big>>, mut b: Vec<Vec<Big>>) -> Vec<Vec<Big>> {
    let n = a.len();
    let zero = Big::zero();
    for k in 0..n {
        let size = |row: usize, a: &[Vec<Big>]| a[row][k].abs();
        let pivot = (k + 1..n).fold(k, |best, row| {
            if size(row, &a) > size(best, &a) {
                row
            } else {
                best
            }
        });
        a.swap(k, pivot);
        b.swap(k, pivot);
        assert!(a[k][k] != zero, "the matrix is singular");
        for row in k + 1..n {
            let factor = &a[row][k] / &a[k][k];
            if factor == zero {
                continue;
            }
            for matrix in [&mut a, &mut b] {
                let (above, below) = matrix.split_at_mut(row);
                for (entry, of_pivot) in below[0].iter_mut().zip(&above[k]) {
                    *entry = &*entry - &factor * of_pivot;
                }
            }
        }
    }
    for k in (0..n).rev() {
        let (above, below) = b.split_at_mut(k + 1);
        for (column, entry) in above[k].iter_mut().enumerate() {
            let known = below.iter().zip(&a[k][k + 1..]);
            let rest = known.fold(entry.clone(), |rest, (x, factor)| {
                rest - factor * &x[column]
            });
            *entry = rest / &a[k][k];
        }
    }
    b
}

#[cfg(test)]
mod tests {
    use super::solve;
    use crate::big::Big;

    /// A Hilbert matrix, with condition number 10¹³, and a zero at the first pivot.
    #[test]
    fn solutions_satisfy_the_equations() {
        let n = 10;
        let mut a: Vec<Vec<Big>> = (0..n)
            .map(|i| {
                (0..n)
                    .map(|j| Big::one() / Big::new(f64::from(i + j + 1)))
                    .collect()
            })
            .collect();
        a[0][0] = Big::zero();
        let b: Vec<Vec<Big>> = (0..n)
            .map(|i| vec![Big::new(f64::from(i)), Big::one()])
            .collect();
        let x = solve(a.clone(), b.clone());
        for (row, b) in a.iter().zip(&b) {
            for column in 0..2 {
                let terms = row.iter().zip(&x);
                let sum = terms.fold(Big::zero(), |sum, (a, x)| sum + a * &x[column]);
                assert!((sum - &b[column]).abs() < Big::new(1e-55));
            }
        }
    }

    #[test]
    #[should_panic(expected = "singular")]
    fn a_singular_matrix_panics() {
        let row = || vec![Big::one(), Big::new(2.0)];
        let _ = solve(vec![row(), row()], vec![vec![Big::one()]; 2]);
    }
}
