//! Dense 4×4 matrices of 256 bits.
//!
//! In: sixteen numbers. Out: sums, products, transposes and the blocks that the paper names. Only the inverse requires
//! a position matrix.

use core::array::from_fn;
use core::ops::{Add, Mul, Sub};

use crate::big::Big;

/// Sixteen numbers, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix(pub [[Big; 4]; 4]);

impl Matrix {
    /// A matrix entry by entry.
    #[must_use]
    pub fn of(entry: impl Fn(usize, usize) -> Big) -> Self {
        Self(from_fn(|i| from_fn(|j| entry(i, j))))
    }

    /// 0.
    #[must_use]
    pub fn zero() -> Self {
        Self::of(|_, _| Big::zero())
    }

    /// 1.
    #[must_use]
    pub fn identity() -> Self {
        Self::of(|i, j| if i == j { Big::one() } else { Big::zero() })
    }

    /// The position matrix 1, t; 0, 1.
    #[must_use]
    pub fn translation(t: &[Big; 3]) -> Self {
        let mut matrix = Self::identity();
        for (row, entry) in matrix.0.iter_mut().zip(t) {
            row[3] = entry.clone();
        }
        matrix
    }

    /// u̲, b; 0, 0.
    #[must_use]
    pub fn screw(u: &[Big; 3], b: &[Big; 3]) -> Self {
        let [x, y, z] = u;
        let mut matrix = Self::zero();
        let rows = [
            [Big::zero(), -z, y.clone()],
            [z.clone(), Big::zero(), -x],
            [-y, x.clone(), Big::zero()],
        ];
        for (i, row) in rows.into_iter().enumerate() {
            let [first, second, third] = row;
            matrix.0[i] = [first, second, third, b[i].clone()];
        }
        matrix
    }

    /// Xᵗ.
    #[must_use]
    pub fn transposed(&self) -> Self {
        Self::of(|i, j| self.0[j][i].clone())
    }

    /// k X.
    #[must_use]
    pub fn times(&self, k: &Big) -> Self {
        Self::of(|i, j| &self.0[i][j] * k)
    }

    /// M⁻¹ = Rᵗ, −Rᵗt; 0, 1 of a position matrix (Part I, § 2.2).
    #[must_use]
    pub fn inverse(&self) -> Self {
        let mut inverse = Self::identity();
        for i in 0..3 {
            for j in 0..3 {
                inverse.0[i][j] = self.0[j][i].clone();
            }
            inverse.0[i][3] =
                -(0..3).fold(Big::zero(), |sum, k| sum + &self.0[k][i] * &self.0[k][3]);
        }
        inverse
    }

    /// Tr(X).
    #[must_use]
    pub fn trace(&self) -> Big {
        (0..4).fold(Big::zero(), |sum, i| sum + &self.0[i][i])
    }

    /// The vector of the skew upper left block.
    #[must_use]
    pub fn vector(&self) -> [Big; 3] {
        [(2, 1), (0, 2), (1, 0)].map(|(i, j)| self.0[i][j].clone())
    }

    /// The upper three entries of the last column.
    #[must_use]
    pub fn column(&self) -> [Big; 3] {
        from_fn(|i| self.0[i][3].clone())
    }

    /// The upper three rows, one after the other.
    #[must_use]
    pub fn rows(&self) -> Vec<Big> {
        self.0[..3].as_flattened().to_vec()
    }
}

impl Mul for &Matrix {
    type Output = Matrix;

    fn mul(self, other: Self) -> Matrix {
        // Most entries are 0, and products of 256 bits are slow.
        let zero = Big::zero();
        Matrix::of(|i, j| {
            (0..4)
                .map(|k| (&self.0[i][k], &other.0[k][j]))
                .filter(|&(x, y)| *x != zero && *y != zero)
                .fold(Big::zero(), |sum, (x, y)| sum + x * y)
        })
    }
}

impl Add for &Matrix {
    type Output = Matrix;

    fn add(self, other: Self) -> Matrix {
        Matrix::of(|i, j| &self.0[i][j] + &other.0[i][j])
    }
}

impl Sub for &Matrix {
    type Output = Matrix;

    fn sub(self, other: Self) -> Matrix {
        Matrix::of(|i, j| &self.0[i][j] - &other.0[i][j])
    }
}
