//! Axes x and y orthogonal to a third one: of the plane of a planar joint, and of a joint that closes a loop.
//!
//! x is the orthogonal part of (c², a², b²), normalized, where the third axis is (a, b, c), and y completes the frame.
//! For the third axes ±x, ±y and ±z, x is y, z and x in turn. No rule is continuous for all directions; this one is,
//! except at ±(1, 1, 1), where (c², a², b²) has no orthogonal part: there (1, 0, 0) is used.
//! In: a direction of length 1. Out: true if it is one of these two.

/// Largest difference between entries of a direction that counts as ±(1, 1, 1): a direction nearer to it leaves too few
/// digits of the orthogonal part.
const NEAR: f64 = 1e-6;

/// True if the part of (c², a², b²) that is orthogonal to (a, b, c) is negligible.
#[must_use]
pub fn is_diagonal([a, b, c]: [f64; 3]) -> bool {
    [a - b, b - c, c - a]
        .iter()
        .all(|difference| difference.abs() < NEAR)
}
