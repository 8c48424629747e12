//! Units of rows and of columns, in which entries of a matrix can be compared.
//!
//! In: a matrix of sizes, each row and each column in a unit of its own. Out: those units, powers of two, in which the
//! largest size of each row and of each column is about one (Ruiz, "A scaling algorithm to equilibrate both rows and
//! columns norms in matrices", 2001).

const TIMES: usize = 8;

/// Units of the rows and of the columns.
pub(super) fn units(mut sizes: Vec<Vec<f64>>) -> [Vec<f64>; 2] {
    let columns = sizes.first().map_or(0, Vec::len);
    let mut units = [vec![1.0; sizes.len()], vec![1.0; columns]];
    for _ in 0..TIMES {
        let of_rows = sizes.iter().map(|row| root(row.iter().copied()));
        let of_columns = (0..columns).map(|column| root(sizes.iter().map(|row| row[column])));
        let more: [Vec<f64>; 2] = [of_rows.collect(), of_columns.collect()];
        for (row, of_row) in sizes.iter_mut().zip(&more[0]) {
            for (size, of_column) in row.iter_mut().zip(&more[1]) {
                *size /= of_row * of_column;
            }
        }
        for (units, more) in units.iter_mut().zip(&more) {
            for (unit, more) in units.iter_mut().zip(more) {
                *unit *= more;
            }
        }
    }
    units
}

/// A power of two near the root of the largest size, the same on every platform; 1 if all are zero.
fn root(sizes: impl Iterator<Item = f64>) -> f64 {
    let largest = sizes.fold(0.0, f64::max);
    if largest > 0.0 {
        // Half of the exponent, whose bias is 1023.
        let exponent = largest.to_bits() >> 52;
        f64::from_bits(u64::midpoint(exponent, 1023) << 52)
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::units;

    #[test]
    fn sizes_in_their_units_are_about_one() {
        let sizes = vec![vec![1e-18, 4e-6], vec![3e-12, 2.0], vec![0.0, 0.0]];
        let [rows, columns] = units(sizes.clone());
        let largest = |sizes: &mut dyn Iterator<Item = f64>| sizes.fold(0.0, f64::max);
        for (row, of_row) in sizes[..2].iter().zip(&rows) {
            let mut sizes = row
                .iter()
                .zip(&columns)
                .map(|(size, of)| size / of_row / of);
            assert!((0.25..=4.0).contains(&largest(&mut sizes)));
        }
        for (column, of_column) in columns.iter().enumerate() {
            let sizes = sizes.iter().zip(&rows);
            let mut sizes = sizes.map(|(row, of_row)| row[column] / of_row / of_column);
            assert!((0.25..=4.0).contains(&largest(&mut sizes)));
        }
        assert_eq!(rows[2], 1.0);
    }
}
