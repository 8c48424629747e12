//! `Display` of typed matrices.
//!
//! In: the sixteen entries, and width and precision of the format, as in `{:9.3}`. Out: four rows in brackets,
//! each column as wide as its widest entry. Without a precision every entry has all of its digits.

use core::fmt::{Display, Formatter, Result, Write};

use super::acceleration::Acceleration;
use super::action::Action;
use super::displacement::Displacement;
use super::inertia::Inertia;
use super::momentum::Momentum;
use super::pose::Pose;
use super::screw::Screw;
use super::velocity::Velocity;
use crate::scalar::Scalar;

/// A writer that counts characters.
struct Length(usize);

impl Write for Length {
    fn write_str(&mut self, text: &str) -> Result {
        self.0 += text.chars().count();
        Ok(())
    }
}

/// Writes an entry in the given precision.
fn entry<T: Display>(number: &T, precision: Option<usize>, into: &mut dyn Write) -> Result {
    match precision {
        Some(digits) => write!(into, "{number:.digits$}"),
        None => write!(into, "{number}"),
    }
}

/// Writes four rows, without a line break after the last.
fn rows<T: Display>(matrix: &[[T; 4]; 4], f: &mut Formatter<'_>) -> Result {
    let precision = f.precision();
    let mut widths = [f.width().unwrap_or(0); 4];
    for row in matrix {
        for (width, number) in widths.iter_mut().zip(row) {
            let mut length = Length(0);
            entry(number, precision, &mut length)?;
            *width = length.0.max(*width);
        }
    }
    for (k, row) in matrix.iter().enumerate() {
        f.write_str(if k == 0 { "[" } else { "\n[" })?;
        for (column, (width, number)) in widths.iter().zip(row).enumerate() {
            let mut length = Length(0);
            entry(number, precision, &mut length)?;
            let blanks = width - length.0 + usize::from(column > 0);
            for _ in 0..blanks {
                f.write_char(' ')?;
            }
            entry(number, precision, f)?;
        }
        f.write_char(']')?;
    }
    Ok(())
}

macro_rules! display {
    ($($matrix:ident)*) => {$(
        /// The 4×4 matrix, one line a row. `{:.3}` rounds entries, `{:9.3}` widens columns.
        impl<T: Scalar + Display> Display for $matrix<T> {
            fn fmt(&self, f: &mut Formatter<'_>) -> Result {
                rows(&self.to_matrix(), f)
            }
        }
    )*};
}

display!(Pose Displacement Screw Velocity Acceleration Inertia Momentum Action);
