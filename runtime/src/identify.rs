//! Identification of base parameters from measured torques, by linear least squares.
//!
//! In: rows of a regressor, each with a measured torque. Out: the parameters of least squares, their standard
//! deviations, and the condition number of the motion.
//!
//! Memory does not grow with the number of rows: only the triangle R of a QR decomposition is kept, which each row
//! updates by Givens rotations (Golub, "Numerical methods for solving linear least squares problems", 1965).
//!
//! ```
//! use homogen::identify::Fit;
//!
//! // τ = 2 q̈ + 0.5 q̇, in three states.
//! let mut fit = Fit::<f64, 2>::new();
//! for [qd, qdd] in [[1.0, 0.0], [0.5, -1.0], [0.0, 2.0]] {
//!     fit.add(&[[qdd, qd]], &[2.0 * qdd + 0.5 * qd]);
//! }
//! let [inertia, damping] = fit.parameters().expect("both are excited");
//! assert!((inertia - 2.0).abs() < 1e-14 && (damping - 0.5).abs() < 1e-14);
//! assert!(fit.condition() < 3.0);
//! ```

use crate::paper::singular_values;
use crate::scalar::Real;
use core::array::from_fn;

/// Least squares of rows Y π = τ for `P` parameters π.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit<T, const P: usize> {
    /// R of the rows so far, and its right-hand side.
    triangle: [[T; P]; P],
    right: [T; P],
    /// The sum of the squared residuals.
    residual: T,
    rows: usize,
}

impl<T: Real, const P: usize> Default for Fit<T, P> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Real, const P: usize> Fit<T, P> {
    /// No rows.
    #[must_use]
    pub fn new() -> Self {
        let zero = T::constant(0.0);
        Self {
            triangle: [[zero; P]; P],
            right: [zero; P],
            residual: zero,
            rows: 0,
        }
    }

    /// Adds rows of a regressor, such as those of one state, with a measured torque for each.
    ///
    /// If measurements have different standard deviations, divide each row and its torque by its deviation first.
    pub fn add<const N: usize>(&mut self, regressor: &[[T; P]; N], measured: &[T; N]) {
        for (row, &measured) in regressor.iter().zip(measured) {
            self.update(*row, measured);
            self.rows += 1;
        }
    }

    /// Updates the triangle with a row, by Givens rotations.
    fn update(&mut self, mut row: [T; P], mut measured: T) {
        if !row.iter().chain([&measured]).all(|entry| entry.is_finite()) {
            self.residual = T::constant(f64::NAN);
            return;
        }
        for (k, triangle) in self.triangle.iter_mut().enumerate() {
            let size = triangle[k].abs().max(row[k].abs());
            if row[k] == T::constant(0.0) {
                continue;
            }
            // Scaled, so that squares neither overflow nor vanish.
            let (a, b) = (triangle[k] / size, row[k] / size);
            let length = (a * a + b * b).sqrt();
            let rotate = |above: &mut T, below: &mut T| {
                let (a, b) = (a / length, b / length);
                (*above, *below) = (a * *above + b * *below, a * *below - b * *above);
            };
            let below = row[k..].iter_mut();
            triangle[k..]
                .iter_mut()
                .zip(below)
                .for_each(|(above, below)| rotate(above, below));
            rotate(&mut self.right[k], &mut measured);
        }
        self.residual = self.residual + measured * measured;
    }

    /// Number of rows.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.rows
    }

    /// The condition number of the regressor, its largest singular value over the smallest: infinite if the motions do
    /// not excite a parameter or a combination of parameters.
    ///
    /// The relative error of the parameters is at most this multiple of that of the measurements. It depends on units.
    #[must_use]
    pub fn condition(&self) -> T {
        let (values, rank) = singular_values::values(&mut self.triangle.clone());
        match (values.first(), values.last()) {
            (Some(first), Some(last)) if rank == P => *first / *last,
            (None, _) => T::constant(1.0),
            _ => T::constant(f64::INFINITY),
        }
    }

    /// The parameters of least squares; `None` if not all are excited, or if a row had NaN or infinity.
    #[must_use]
    pub fn parameters(&self) -> Option<[T; P]> {
        let determined = self.residual.is_finite() && self.condition().is_finite();
        determined.then(|| self.solved(self.right))
    }

    /// An estimate of the standard deviation of the measurements, in their unit: the root of the sum of the squared
    /// residuals over the number of rows minus `P`. Zero if there are no more than `P` rows; NaN if a row had NaN or
    /// infinity.
    #[must_use]
    pub fn standard_deviation(&self) -> T {
        let excess = u32::try_from(self.rows.saturating_sub(P)).unwrap_or(u32::MAX);
        if excess == 0 {
            return T::constant(0.0);
        }
        (self.residual / T::constant(f64::from(excess))).sqrt()
    }

    /// The standard deviation of each parameter, in its unit, if the errors of the measurements are independent, each
    /// with [`standard_deviation`](Self::standard_deviation); `None` as for [`parameters`](Self::parameters).
    #[must_use]
    pub fn standard_deviations(&self) -> Option<[T; P]> {
        self.parameters()?;
        let standard_deviation = self.standard_deviation();
        let [zero, one] = [0.0, 1.0].map(T::constant);
        // The variances are the diagonal of R⁻¹ R⁻ᵗ.
        let mut squares = [zero; P];
        for k in 0..P {
            let column = self.solved(from_fn(|j| if j == k { one } else { zero }));
            squares = from_fn(|j| squares[j] + column[j] * column[j]);
        }
        Some(squares.map(|square| standard_deviation * square.sqrt()))
    }

    /// R⁻¹ y.
    fn solved(&self, y: [T; P]) -> [T; P] {
        let mut x = y;
        for k in (0..P).rev() {
            let known = (k + 1..P).fold(x[k], |rest, j| rest - self.triangle[k][j] * x[j]);
            x[k] = known / self.triangle[k][k];
        }
        x
    }
}

#[cfg(all(test, feature = "nalgebra"))]
mod tests {
    use super::Fit;
    use homogen_random::Random;
    use nalgebra::{SMatrix, SVector};

    const ROWS: usize = 40;

    /// Rows whose third column is nearly the sum of the first two, and measurements with noise.
    fn drawn(seed: u64, apart: f64) -> ([[f64; 5]; ROWS], [f64; ROWS]) {
        let mut random = Random::new(seed);
        let rows = std::array::from_fn(|_| {
            let [a, b, c, d, e] = std::array::from_fn(|_| random.odd());
            [a, b, a + b + apart * c, 100.0 * d, e]
        });
        let measured = rows.map(|[a, b, c, d, e]: [f64; 5]| {
            a - 2.0 * b + 3.0 * c + 0.04 * d + e + 0.01 * random.odd()
        });
        (rows, measured)
    }

    #[test]
    fn agrees_with_a_decomposition_of_all_rows() {
        for seed in 0..50 {
            let (rows, measured) = drawn(seed, 0.5);
            let mut fit = Fit::<f64, 5>::new();
            fit.add(&rows, &measured);
            let matrix = SMatrix::<f64, ROWS, 5>::from_fn(|i, j| rows[i][j]);
            let right = SVector::<f64, ROWS>::from(measured);
            let svd = matrix.svd(true, true);
            let values = svd.singular_values;
            let condition = values.max() / values.min();
            assert!((fit.condition() / condition - 1.0).abs() < 1e-12);
            let expected = svd.solve(&right, 0.0).expect("both factors");
            let found = fit.parameters().expect("all are excited");
            let left = (matrix * expected - right).norm_squared();
            let standard_deviation = (left / 35.0).sqrt();
            assert!((fit.standard_deviation() / standard_deviation - 1.0).abs() < 1e-10);
            let inverse = (matrix.transpose() * matrix)
                .try_inverse()
                .expect("regular");
            let standard_deviations = fit.standard_deviations().expect("all are excited");
            for k in 0..5 {
                assert!((found[k] - expected[k]).abs() < 1e-12 * expected.norm());
                let expected = standard_deviation * inverse[(k, k)].sqrt();
                assert!((standard_deviations[k] / expected - 1.0).abs() < 1e-9);
            }
            assert_eq!(fit.rows(), ROWS);
        }
    }

    #[test]
    fn parameters_that_are_not_excited_are_none() {
        let (rows, measured) = drawn(7, 0.0);
        let mut fit = Fit::<f64, 5>::new();
        fit.add(&rows, &measured);
        assert!(fit.condition().is_infinite());
        assert_eq!((fit.parameters(), fit.standard_deviations()), (None, None));
        assert_eq!(Fit::<f64, 5>::default().parameters(), None);
    }

    #[test]
    fn nan_and_infinity_give_no_parameters() {
        for bad in [f64::NAN, f64::INFINITY] {
            let (mut rows, measured) = drawn(7, 0.5);
            rows[20][3] = bad;
            let mut fit = Fit::<f64, 5>::new();
            fit.add(&rows, &measured);
            assert_eq!(fit.parameters(), None);
            assert!(fit.standard_deviation().is_nan());
            let (rows, mut measured) = drawn(7, 0.5);
            measured[20] = bad;
            let mut fit = Fit::<f64, 5>::new();
            fit.add(&rows, &measured);
            assert_eq!(fit.parameters(), None);
        }
    }
}
