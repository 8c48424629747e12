//! Axes x and y across a third: of the plane in which a planar joint moves, and of a joint that closes a loop.
//!
//! x is along (c², a², b²), where the third axis is (a, b, c), as far as that is across it, and y completes the
//! frame. Of the axes ±x, ±y and ±z, x is y, z and x in turn. No rule can be continuous for all directions; this
//! one is but at ±(1, 1, 1), where (c², a², b²) has no part across: there x is along (1, 0, 0), as far as that is.
//! In: a direction of length 1. Out: whether it is there.

/// By how much the entries of a direction may differ that is taken for ±(1, 1, 1): what is nearer has too few digits
/// across it.
const NEAR: f64 = 1e-6;

/// Whether (c², a², b²) has no part across (a, b, c) to speak of.
#[must_use]
pub fn is_diagonal([a, b, c]: [f64; 3]) -> bool {
    [a - b, b - c, c - a]
        .iter()
        .all(|difference| difference.abs() < NEAR)
}
