//! 4×4 matrices whose sixteen entries are multiplied out.
//!
//! In: entries of any arithmetic. Out: products, sums, transposes. Zeros and the structure of rotations are not used,
//! so that it shares nothing with [`crate::matrix`].

use std::array::from_fn;

use crate::expression::Arithmetic;

/// Rows of a 4×4 matrix.
#[derive(Clone, Debug)]
pub(crate) struct Matrix<T>(pub(crate) [[T; 4]; 4]);

impl<T: Arithmetic> Matrix<T> {
    pub(crate) fn zero() -> Self {
        Self(from_fn(|_| from_fn(|_| T::literal(0.0))))
    }

    pub(crate) fn identity() -> Self {
        Self(from_fn(|row| {
            from_fn(|column| T::literal(if row == column { 1.0 } else { 0.0 }))
        }))
    }

    /// A rotation by sine and cosine, about the axis of that number.
    pub(crate) fn rotation(axis: usize, (sine, cosine): (T, T)) -> Self {
        let mut matrix = Self::identity();
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        matrix.0[next][next] = cosine.clone();
        matrix.0[last][last] = cosine;
        matrix.0[next][last] = -sine.clone();
        matrix.0[last][next] = sine;
        matrix
    }

    pub(crate) fn translation(offset: [T; 3]) -> Self {
        let mut matrix = Self::identity();
        matrix.set_column(offset);
        matrix
    }

    /// Sets the upper three numbers of the last column.
    pub(crate) fn set_column(&mut self, entries: [T; 3]) {
        for (row, entry) in self.0.iter_mut().zip(entries) {
            row[3] = entry;
        }
    }

    /// The upper three numbers of the last column.
    pub(crate) fn column(&self) -> [T; 3] {
        from_fn(|row| self.0[row][3].clone())
    }

    /// L of u and b: u̲, b; 0, 0.
    pub(crate) fn screw([x, y, z]: [T; 3], b: [T; 3]) -> Self {
        let mut matrix = Self::zero();
        matrix.0[2][1] = x.clone();
        matrix.0[1][2] = -x;
        matrix.0[0][2] = y.clone();
        matrix.0[2][0] = -y;
        matrix.0[1][0] = z.clone();
        matrix.0[0][1] = -z;
        matrix.set_column(b);
        matrix
    }

    /// Q of a displacement q along a screw: 1 + u̲ sin q + u̲² (1 − cos q), and b q, where b is parallel to u.
    pub(crate) fn displacement([u, b]: [[T; 3]; 2], q: &T) -> Self {
        let axis = Self::screw(u, [0.0; 3].map(T::literal));
        let (sine, cosine) = q.clone().sin_cos();
        let versine = T::literal(1.0) - cosine;
        let mut displacement = Self::identity()
            .plus(&axis.scaled(&sine))
            .plus(&axis.times(&axis).scaled(&versine));
        displacement.set_column(b.map(|entry| entry * q.clone()));
        displacement
    }

    /// Φ of c and f: c̲, f; −fᵗ, 0.
    pub(crate) fn action(c: [T; 3], f: [T; 3]) -> Self {
        let mut matrix = Self::screw(c, f.clone());
        for (entry, of_force) in matrix.0[3].iter_mut().zip(f) {
            *entry = -of_force;
        }
        matrix
    }

    /// u and b of a screw matrix, ω and v of a velocity, c and f of a wrench.
    pub(crate) fn vectors(&self) -> [T; 6] {
        [(2, 1), (0, 2), (1, 0), (0, 3), (1, 3), (2, 3)]
            .map(|(row, column)| self.0[row][column].clone())
    }

    /// The upper three rows, one after the other.
    pub(crate) fn upper(&self) -> Vec<T> {
        self.0[..3].iter().flatten().cloned().collect()
    }

    pub(crate) fn transposed(&self) -> Self {
        Self(from_fn(|row| from_fn(|column| self.0[column][row].clone())))
    }

    /// M⁻¹ of a pose: Rᵗ, −Rᵗt; 0, 1.
    pub(crate) fn inverse(&self) -> Self {
        let mut rotation = self.transposed();
        rotation.0[3] = [0.0, 0.0, 0.0, 1.0].map(T::literal);
        let back = self.column().map(|entry| -entry);
        rotation.times(&Self::translation(back))
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        Self(from_fn(|row| {
            from_fn(|column| {
                let term = |k: usize| self.0[row][k].clone() * other.0[k][column].clone();
                term(0) + term(1) + term(2) + term(3)
            })
        }))
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self(from_fn(|row| {
            from_fn(|column| self.0[row][column].clone() + other.0[row][column].clone())
        }))
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self(from_fn(|row| {
            from_fn(|column| self.0[row][column].clone() - other.0[row][column].clone())
        }))
    }

    /// A B − B A.
    pub(crate) fn commutator(&self, other: &Self) -> Self {
        self.times(other).minus(&other.times(self))
    }

    pub(crate) fn scaled(&self, factor: &T) -> Self {
        Self(
            self.0
                .clone()
                .map(|row| row.map(|entry| entry * factor.clone())),
        )
    }

    /// The sum of the diagonal.
    pub(crate) fn trace(&self) -> T {
        let entry = |k: usize| self.0[k][k].clone();
        entry(0) + entry(1) + entry(2) + entry(3)
    }

    /// Tr(Aᵗ B): the sum of the products of entries.
    pub(crate) fn dot(&self, other: &Self) -> T {
        let products = self.0.iter().flatten().zip(other.0.iter().flatten());
        products.fold(T::literal(0.0), |sum, (a, b)| sum + a.clone() * b.clone())
    }

    /// A − Aᵗ.
    pub(crate) fn skew(&self) -> Self {
        self.minus(&self.transposed())
    }

    /// M A M⁻¹: a screw, velocity or acceleration in the frame M, changed to the outer frame.
    pub(crate) fn carries(&self, screw: &Self) -> Self {
        self.times(screw).times(&self.inverse())
    }
}
