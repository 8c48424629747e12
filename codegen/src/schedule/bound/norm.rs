//! Lengths of vectors and norms of small matrices, without overflow or underflow of squares.
//!
//! In: numbers of any size. Out: √(a² + b² + …), and bounds of the spectral norm. NaN is propagated.

use super::combination::ROWS;

/// Bound of the spectral norm of a matrix, given by its columns: the smallest of three bounds. That by the scalar
/// products of the columns is exact for rotations.
pub fn norm(columns: &[[f64; ROWS]]) -> f64 {
    let entries = columns.iter().flatten().map(|entry| entry.abs());
    let unit = entries.fold(0.0, f64::max);
    if unit == 0.0 || !unit.is_finite() {
        return unit;
    }
    let columns: Vec<[f64; ROWS]> = (columns.iter())
        .map(|column| column.map(|entry| entry / unit))
        .collect();
    let dot = |a: &[f64; ROWS], b: &[f64; ROWS]| (0..ROWS).map(|k| a[k] * b[k]).sum::<f64>();
    let largest = |sums: &mut dyn Iterator<Item = f64>| sums.fold(0.0, f64::max);
    let by_columns = largest(&mut columns.iter().map(|a| {
        let products = columns.iter().map(|b| dot(a, b).abs());
        products.sum::<f64>()
    }));
    let by_rows = largest(&mut (0..ROWS).map(|row| {
        let products = (0..ROWS).map(|other| {
            let products = columns.iter().map(|column| column[row] * column[other]);
            products.sum::<f64>().abs()
        });
        products.sum::<f64>()
    }));
    let all = columns
        .iter()
        .map(|column| dot(column, column))
        .sum::<f64>();
    unit * by_columns.min(by_rows).min(all).sqrt()
}

/// √(a² + b² + …).
pub fn root(entries: impl IntoIterator<Item = f64>) -> f64 {
    let sizes = entries.into_iter().map(f64::abs);
    sizes.fold(0.0, both)
}

/// √(a² + b²) of numbers that are not negative, without overflow or underflow of squares.
pub fn both(a: f64, b: f64) -> f64 {
    let (less, more) = (a.min(b), a.max(b));
    // Propagates NaN and infinity.
    if less == 0.0 || !(a + b).is_finite() {
        return a + b;
    }
    let ratio = less / more;
    more * (1.0 + ratio * ratio).sqrt()
}

#[cfg(test)]
mod tests {
    use super::{norm, root};

    #[test]
    fn lengths_of_any_sign_and_size() {
        for size in [1.0, 1e-200, 1e200] {
            let length = root([0.0, -3.0 * size, 4.0 * size]);
            assert!((length / size - 5.0).abs() < 1e-14, "{length:e}");
        }
        assert_eq!(root([0.0, f64::INFINITY]), f64::INFINITY);
        assert!(root([f64::NAN, 1.0]).is_nan());
    }

    #[test]
    fn rotations_have_norm_1_and_offsets_their_length() {
        let rotation = [[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, -1.0]];
        assert!((norm(&rotation) - 1.0).abs() < 1e-15);
        assert!((norm(&rotation[..2]) - 1.0).abs() < 1e-15);
        let lever = [[0.0, 0.0, -2e-200], [0.0, 0.0, 0.0], [2e-200, 0.0, 0.0]];
        assert!((norm(&lever) / 2e-200 - 1.0).abs() < 1e-15);
        // For a row, the length of its entries.
        let row = [[3.0, 0.0, 0.0], [-4.0, 0.0, 0.0]];
        assert!((norm(&row) - 5.0).abs() < 1e-15);
    }
}
