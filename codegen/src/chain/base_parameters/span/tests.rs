//! Tests of which columns are kept.

use super::{SizedEntry, Span};
use crate::expression::Double;
use crate::list::Id;
use crate::space::ParameterId;

/// Entries of a column that are sums of terms of magnitude 1.
fn column(entries: [f64; 3]) -> impl Iterator<Item = SizedEntry> {
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

/// A column with entries of 1e-16 of their terms, of which a multiple of another column has been subtracted: in a row
/// where its own terms are zero, the entry that is left has the size of that multiple alone.
#[test]
fn a_residue_is_told_in_rows_without_terms_of_its_own() {
    let [plain, faint] = [0, 1].map(ParameterId::new);
    let plain_entries = [(1.0, 1.0), (0.5, 1.0), (0.7, 1.0)];
    let faint_entries = [(3e-16, 1.0), (2e-16, 1.0), (0.0, 0.0)];
    let entries = |entries: [(f64, f64); 3]| {
        entries
            .into_iter()
            .map(|(entry, size)| (Double::from(entry), size))
    };
    let mut span = Span::default();
    assert!(span.take(Some(plain), entries(plain_entries)).is_none());
    assert!(!span.left.is_uncertain());
    assert!(span.take(Some(faint), entries(faint_entries)).is_none());
    assert!(span.left.is_uncertain());
}
