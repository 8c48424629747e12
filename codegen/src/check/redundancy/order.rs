//! The order in which the residuals of loops are eliminated.
//!
//! In: S = J M⁻¹ Jᵗ in some configurations, with a diagonal relative to the wholes; and the number of residuals of each
//! loop. Out: the residuals, loop after loop as described; but one that nearly depends on those before it comes after
//! the others of its loop. A ball in an inclined plane has two independent residuals of three. Which two decides how
//! many digits an elimination without pivoting loses.

/// Ratio of pivots above which a residual comes before those described before it: 6 bits.
const FAR_MORE: f64 = 64.0;

/// The order. Rows without a pivot above `zero` in any configuration keep theirs.
pub(super) fn order(
    mut configurations: Vec<Vec<Vec<f64>>>,
    loops: impl Iterator<Item = usize>,
    zero: f64,
) -> Vec<usize> {
    let mut order = Vec::new();
    for count in loops {
        let mut open: Vec<usize> = (order.len()..order.len() + count).collect();
        while let Some(place) = next(&open, &configurations, zero) {
            let k = open.remove(place);
            order.push(k);
            for s in &mut configurations {
                eliminate(s, k, zero);
            }
        }
        order.extend(open);
    }
    order
}

/// The place of the next row among the open ones; `None` if all that are left depend on those before.
fn next(open: &[usize], configurations: &[Vec<Vec<f64>>], zero: f64) -> Option<usize> {
    let largest = |s: &Vec<Vec<f64>>| open.iter().fold(0.0_f64, |most, &k| most.max(s[k][k]));
    let useful: Vec<(&Vec<Vec<f64>>, f64)> = (configurations.iter())
        .map(|s| (s, largest(s)))
        .filter(|(_, largest)| *largest > zero)
        .collect();
    let least = |k: usize| {
        let shares = useful.iter().map(|(s, largest)| s[k][k] / largest);
        shares.fold(1.0, f64::min)
    };
    let shares: Vec<f64> = open.iter().map(|&k| least(k)).collect();
    let most = shares.iter().copied().fold(0.0, f64::max);
    let mut places = shares.iter();
    (!useful.is_empty()).then(|| {
        let place = places.position(|share| share * FAR_MORE >= most);
        place.expect("one has the largest share")
    })
}

/// Subtracts what the other rows have in common with row k, unless its pivot is negligible.
fn eliminate(s: &mut [Vec<f64>], k: usize, zero: f64) {
    let of_pivot = s[k].clone();
    if of_pivot[k] <= zero {
        return;
    }
    for (i, row) in s.iter_mut().enumerate().filter(|(i, _)| *i != k) {
        let factor = of_pivot[i] / of_pivot[k];
        for (entry, of_pivot) in row.iter_mut().zip(&of_pivot) {
            *entry -= factor * of_pivot;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::order;

    /// Products of rows with each other.
    fn products(rows: &[[f64; 3]]) -> Vec<Vec<f64>> {
        let product = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|k| a[k] * b[k]).sum();
        let row = |a| rows.iter().map(|b| product(a, b)).collect();
        rows.iter().map(row).collect()
    }

    #[test]
    fn independent_rows_keep_their_order() {
        let rows = [[1.0, 0.2, 0.0], [0.0, 0.5, 0.1], [0.3, 0.0, 0.3]];
        assert_eq!(
            order(vec![products(&rows)], [3].into_iter(), 1e-8),
            [0, 1, 2]
        );
    }

    #[test]
    fn a_row_that_nearly_depends_comes_after_the_others_of_its_loop() {
        let rows = [
            [1.0, 0.0, 0.0],
            [1.0, 1e-3, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
        ];
        let loops = || [3, 1].into_iter();
        assert_eq!(order(vec![products(&rows)], loops(), 1e-8), [0, 2, 1, 3]);
        // One configuration in which it depends is enough.
        let elsewhere = [
            [1.0, 0.0, 0.0],
            [0.5, 1.0, 0.0],
            [0.0, 1.0, 0.5],
            [0.0, 0.0, 1.0],
        ];
        let both = vec![products(&elsewhere), products(&rows)];
        assert_eq!(order(both, loops(), 1e-8), [0, 2, 1, 3]);
    }

    #[test]
    fn dependent_rows_keep_their_order() {
        let rows = [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1e-5, 0.0]];
        assert_eq!(
            order(vec![products(&rows)], [3].into_iter(), 1e-8),
            [0, 1, 2]
        );
    }
}
