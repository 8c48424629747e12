//! Tests of which columns are kept.

use super::{Entry, Span};
use crate::expression::Double;
use crate::list::Id;
use crate::space::ParameterId;

/// Entries of a column that are sums of terms of magnitude 1.
fn column(entries: [f64; 3]) -> impl Iterator<Item = Entry> {
    entries.into_iter().map(|entry| (Double::from(entry), 1.0))
}

/// A prismatic joint is askew by 1e-10 rad. Of two of its moments of inertia, the revolute joint before it sees one
/// fully and the other one by the square of that angle, to ten digits. A combination with the latter has no more
/// digits.
#[test]
fn the_column_with_the_largest_residual_leads() {
    let [faint, plain, further] = [0, 1, 2].map(ParameterId::new);
    let seen = [0.3, 0.7, 0.5];
    let mut span = Span::default();
    let columns = [
        (faint, column(seen.map(|entry| entry * 1e-20))),
        (plain, column(seen)),
    ];
    span.take_some(columns.into_iter());
    let combination = span.take(Some(further), column(seen.map(|entry| entry * 2.0)));
    let names = combination.map(|terms| {
        let factors = terms.into_iter();
        let factors = factors.map(|(name, factor)| (name, factor.to_f64()));
        factors.collect::<Vec<_>>()
    });
    assert_eq!(names, Some(vec![(plain, 2.0)]));
}
