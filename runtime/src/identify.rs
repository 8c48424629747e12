//! Identification: what base parameters must be for a robot to need the torques that were measured.
//!
//! In: rows of a regressor, each with what was measured. Out: the parameters that fit them best, how well each of them
//! is known, and how well the motions excite them all. It allocates nothing: of all rows it keeps a triangle as wide
//! as there are parameters, into which each new row is turned (Golub, "Numerical methods for solving linear least
//! squares problems", 1965, by rotations), so that a motion may be as long as it likes. It knows no robot.
//!
//! ```
//! use homogen::identify::Fit;
//!
//! // τ = 2 q̈ + 0.5 q̇, at three moments.
//! let mut fit = Fit::<f64, 2>::new();
//! for [qd, qdd] in [[1.0, 0.0], [0.5, -1.0], [0.0, 2.0]] {
//!     fit.add(&[[qdd, qd]], &[2.0 * qdd + 0.5 * qd]);
//! }
//! let [inertia, damping] = fit.parameters().expect("both move it");
//! assert!((inertia - 2.0).abs() < 1e-14 && (damping - 0.5).abs() < 1e-14);
//! assert!(fit.excitation() < 3.0);
//! ```

use crate::paper::singular_values;
use crate::scalar::Real;
use core::array::from_fn;

/// Rows of Y π = τ, as far as they tell of the `P` parameters π.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit<T, const P: usize> {
    /// R of the rows so far, and what stands on the right of it.
    triangle: [[T; P]; P],
    right: [T; P],
    /// The sum of the squares of what no parameters explain.
    left: T,
    rows: usize,
}

impl<T: Real, const P: usize> Default for Fit<T, P> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Real, const P: usize> Fit<T, P> {
    /// Of no rows yet.
    #[must_use]
    pub fn new() -> Self {
        let zero = T::constant(0.0);
        Self {
            triangle: [[zero; P]; P],
            right: [zero; P],
            left: zero,
            rows: 0,
        }
    }

    /// Takes rows of a regressor, such as those of a state, and what was measured in the place of each.
    ///
    /// Where measurements are not equally exact, rows and torques are divided by the standard deviation of each.
    pub fn add<const N: usize>(&mut self, regressor: &[[T; P]; N], measured: &[T; N]) {
        for (row, &measured) in regressor.iter().zip(measured) {
            self.turn_in(*row, measured);
            self.rows += 1;
        }
    }

    /// Turns a row into the triangle, whose rows stay as long together.
    fn turn_in(&mut self, mut row: [T; P], mut measured: T) {
        if !row.iter().chain([&measured]).all(|entry| entry.is_finite()) {
            self.left = T::constant(f64::NAN);
            return;
        }
        for (k, triangle) in self.triangle.iter_mut().enumerate() {
            let size = triangle[k].abs().max(row[k].abs());
            if row[k] == T::constant(0.0) {
                continue;
            }
            // Scaled, so that no square of a size that occurs is lost.
            let (a, b) = (triangle[k] / size, row[k] / size);
            let length = (a * a + b * b).sqrt();
            let turn = |above: &mut T, below: &mut T| {
                let (a, b) = (a / length, b / length);
                (*above, *below) = (a * *above + b * *below, a * *below - b * *above);
            };
            let below = row[k..].iter_mut();
            triangle[k..]
                .iter_mut()
                .zip(below)
                .for_each(|(above, below)| turn(above, below));
            turn(&mut self.right[k], &mut measured);
        }
        self.left = self.left + measured * measured;
    }

    /// How many rows there are.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.rows
    }

    /// How well the motions excite all parameters: the condition number of all rows, the largest singular value of
    /// their matrix over the smallest. Infinite where a parameter, or a combination of some, is not excited at all.
    ///
    /// It depends on the units: errors of parameters are at most so many times, relatively, those of what is measured.
    #[must_use]
    pub fn excitation(&self) -> T {
        let (values, rank) = singular_values::values(&mut self.triangle.clone());
        match (values.first(), values.last()) {
            (Some(first), Some(last)) if rank == P => *first / *last,
            (None, _) => T::constant(1.0),
            _ => T::constant(f64::INFINITY),
        }
    }

    /// The parameters that leave the least sum of squares; none where not all are excited, or where a row had an entry
    /// that is no finite number.
    #[must_use]
    pub fn parameters(&self) -> Option<[T; P]> {
        let told = self.left.is_finite() && self.excitation().is_finite();
        told.then(|| self.solved(self.right))
    }

    /// The root of the mean of the squares that these parameters leave, over what the number of rows leaves free: an
    /// estimate of the standard deviation of what was measured, in its unit. Zero where no row is left over; NaN where a
    /// row had an entry that is no finite number.
    #[must_use]
    pub fn deviation(&self) -> T {
        let free = u32::try_from(self.rows.saturating_sub(P)).unwrap_or(u32::MAX);
        if free == 0 {
            return T::constant(0.0);
        }
        (self.left / T::constant(f64::from(free))).sqrt()
    }

    /// The standard deviation of each parameter, in its unit, where measurements are off by a [`deviation`](Self::deviation)
    /// without knowing of each other; none where not all are excited.
    #[must_use]
    pub fn deviations(&self) -> Option<[T; P]> {
        self.parameters()?;
        let each = self.deviation();
        let [zero, one] = [0.0, 1.0].map(T::constant);
        // The squares stand on the diagonal of R⁻¹ R⁻ᵗ.
        let mut squares = [zero; P];
        for k in 0..P {
            let column = self.solved(from_fn(|j| if j == k { one } else { zero }));
            squares = from_fn(|j| squares[j] + column[j] * column[j]);
        }
        Some(squares.map(|square| each * square.sqrt()))
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

    /// Rows of which the third column is nearly the sum of the first two, and measurements with noise.
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
            let excitation = values.max() / values.min();
            assert!((fit.excitation() / excitation - 1.0).abs() < 1e-12);
            let expected = svd.solve(&right, 0.0).expect("both factors");
            let found = fit.parameters().expect("all are excited");
            let left = (matrix * expected - right).norm_squared();
            let deviation = (left / 35.0).sqrt();
            assert!((fit.deviation() / deviation - 1.0).abs() < 1e-10);
            let inverse = (matrix.transpose() * matrix)
                .try_inverse()
                .expect("regular");
            let deviations = fit.deviations().expect("all are excited");
            for k in 0..5 {
                assert!((found[k] - expected[k]).abs() < 1e-12 * expected.norm());
                let expected = deviation * inverse[(k, k)].sqrt();
                assert!((deviations[k] / expected - 1.0).abs() < 1e-9);
            }
            assert_eq!(fit.rows(), ROWS);
        }
    }

    #[test]
    fn what_is_not_excited_is_not_told() {
        let (rows, measured) = drawn(7, 0.0);
        let mut fit = Fit::<f64, 5>::new();
        fit.add(&rows, &measured);
        assert!(fit.excitation().is_infinite());
        assert_eq!((fit.parameters(), fit.deviations()), (None, None));
        assert_eq!(Fit::<f64, 5>::default().parameters(), None);
    }

    #[test]
    fn what_is_no_number_makes_no_parameters_of_it() {
        for bad in [f64::NAN, f64::INFINITY] {
            let (mut rows, measured) = drawn(7, 0.5);
            rows[20][3] = bad;
            let mut fit = Fit::<f64, 5>::new();
            fit.add(&rows, &measured);
            assert_eq!(fit.parameters(), None);
            assert!(fit.deviation().is_nan());
            let (rows, mut measured) = drawn(7, 0.5);
            measured[20] = bad;
            let mut fit = Fit::<f64, 5>::new();
            fit.add(&rows, &measured);
            assert_eq!(fit.parameters(), None);
        }
    }
}
