//! Quaternions of random states.
//!
//! In: any four numbers. Out: a quaternion of length 1 in nearly their direction.

use crate::expression::Double;
use crate::real::Real;

/// Normalizes four numbers to length 1, to a hundred bits. They are scaled first by a power of two, so that no square
/// overflows or underflows.
pub fn normalize(entries: &mut [Double]) {
    let exponents = entries.iter().map(|entry| entry.exponent());
    let largest = exponents.max().unwrap_or(0);
    for entry in &mut *entries {
        *entry = entry.scaled(-largest);
    }
    let squares = entries.iter().map(|&entry| entry * entry);
    let length = squares.fold(Double::ZERO, |sum, square| sum + square);
    let length = length.sqrt();
    for entry in entries {
        *entry = *entry / length;
    }
}

/// A quaternion of a type of numbers, whose length is 1 to ten bits more than the type has: all formulas give the same
/// rotation for it.
///
/// The only quaternions of length 1 to the last digit, in any type, are the 24 whose entries are ±½, or ±1 and zeros;
/// they map axes to axes. So three entries are truncated to half of the digits, and the entry `small` is computed from
/// them: it is so small that its rounding is negligible.
#[must_use]
pub fn of_length_1(direction: [f64; 4], small: usize, scalar: Real) -> [f64; 4] {
    let grid = match scalar {
        Real::F32 => f64::from(1_u32 << 12),
        Real::F64 | Real::Generic => f64::from(1_u32 << 24),
    };
    let mut entries = direction;
    entries[small] = 0.0;
    let squares = |entries: [f64; 4]| entries.iter().map(|entry| entry * entry).sum::<f64>();
    let length = squares(entries).sqrt();
    entries = entries.map(|entry| (entry / length * grid).trunc() / grid);
    // Squares of so few digits, and their sum, are exact.
    let left = (1.0 - squares(entries)).max(0.0).sqrt();
    entries[small] = scalar.rounded(left).copysign(direction[small]);
    entries
}

#[cfg(test)]
mod tests;
