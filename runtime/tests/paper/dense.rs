//! The dense side of each equation: 4×4 products without structure, and comparison in units of rounding.

use homogen::Real;
use std::array::from_fn;

pub type Dense<T> = [[T; 4]; 4];

pub fn product<T: Real>(x: &Dense<T>, y: &Dense<T>) -> Dense<T> {
    from_fn(|i| from_fn(|j| (0..4).fold(T::constant(0.0), |sum, k| sum + x[i][k] * y[k][j])))
}

pub fn apply<T: Real>(x: &Dense<T>, p: [T; 4]) -> [T; 4] {
    x.map(|row| (0..4).fold(T::constant(0.0), |sum, k| sum + row[k] * p[k]))
}

pub fn transpose<T: Real>(x: &Dense<T>) -> Dense<T> {
    from_fn(|i| from_fn(|j| x[j][i]))
}

pub fn combine<T: Real>(a: f64, x: &Dense<T>, b: f64, y: &Dense<T>) -> Dense<T> {
    from_fn(|i| from_fn(|j| T::constant(a) * x[i][j] + T::constant(b) * y[i][j]))
}

/// skew[X] = X − Xᵗ.
pub fn skew<T: Real>(x: &Dense<T>) -> Dense<T> {
    combine(1.0, x, -1.0, &transpose(x))
}

pub fn trace<T: Real>(x: &Dense<T>) -> T {
    x[0][0] + x[1][1] + x[2][2] + x[3][3]
}

/// The largest magnitude.
pub fn size<T: Real>(values: impl IntoIterator<Item = T>) -> T {
    values
        .into_iter()
        .fold(T::constant(0.0), |m, x| m.max(x.abs()))
}

pub fn size_of<T: Real>(x: &Dense<T>) -> T {
    size(x.iter().flatten().copied())
}

/// u, the unit roundoff.
pub fn unit_roundoff<T: Real>() -> T {
    T::EPSILON * T::constant(0.5)
}

/// Asserts |actual − expected| ≤ units · u · scale for every entry.
#[track_caller]
pub fn assert_within<T: Real, A, B>(actual: A, expected: B, scale: T, units: f64)
where
    A: IntoIterator<Item = T>,
    B: IntoIterator<Item = T>,
{
    let bound = T::constant(units) * unit_roundoff::<T>() * scale;
    for (i, (a, b)) in actual.into_iter().zip(expected).enumerate() {
        let error = (a - b).abs();
        assert!(
            error <= bound,
            "entry {i}: {a} is not {b}; {} units off, {units} allowed",
            error.to_f64() / (unit_roundoff::<T>() * scale).to_f64(),
        );
    }
}

/// The same for 4×4 matrices, the scale being at least the largest entry expected.
#[track_caller]
pub fn assert_same<T: Real>(actual: &Dense<T>, expected: &Dense<T>, scale: T, units: f64) {
    assert_within(
        actual.iter().flatten().copied(),
        expected.iter().flatten().copied(),
        scale.max(size_of(expected)),
        units,
    );
}
