//! What a row of columns spans.
//!
//! In: columns of parameters, one after the other. Out: of each that adds nothing, the combination of earlier ones that
//! it is; and how near the nearest decision was. It never knows what is in them.

use crate::space::ParameterId;

/// A column is a combination of others where no more than this part of it is left.
const NOTHING: f64 = 1e-9;

/// What is left of a part, or of a column beside the longest, is rounding.
pub const ROUNDED: f64 = 1e-11;

/// Beside a column so long, what torques see of a moment of inertia about its own joint, an acceleration of about
/// 1 rad/s², is not known from rounding.
const LONG: f64 = 0.01 / ROUNDED;

/// Columns that do not depend on each other.
pub struct Span<'c> {
    columns: Vec<(ParameterId, &'c [f64])>,
    /// Perpendicular directions of length 1, each with its factors of the columns.
    directions: Vec<(Vec<f64>, Vec<f64>)>,
    /// The length of the longest column of those to come.
    longest: f64,
    /// The largest part that was left of a column which was taken for a combination of others, or, beside the longest,
    /// for nothing.
    nearest: f64,
}

impl<'c> Span<'c> {
    /// None yet, of all these.
    pub fn among(all: impl Iterator<Item = &'c Vec<f64>>) -> Self {
        let lengths = all.map(|column| length(column));
        Self {
            columns: Vec::new(),
            directions: Vec::new(),
            longest: lengths.fold(0.0, f64::max),
            nearest: 0.0,
        }
    }

    /// How far a column that was taken for a combination of others is from one at most, beside its length; or beside
    /// that of the longest, where it was taken for nothing.
    pub fn nearest(&self) -> f64 {
        self.nearest
    }

    /// Adds a column; or, where it depends on those that are there, says how: so much of each.
    pub fn take(
        &mut self,
        name: ParameterId,
        column: &'c [f64],
    ) -> Option<Vec<(ParameterId, f64)>> {
        let whole = length(column);
        let mut left = column.to_vec();
        let mut factors = vec![0.0; self.columns.len()];
        // Twice is enough (Giraud and others, 2005).
        for _ in 0..2 {
            for (direction, of_columns) in &self.directions {
                let part = dot(direction, &left);
                add(&mut left, direction, -part);
                add(&mut factors, of_columns, part);
            }
        }
        let rest = length(&left);
        if rest > NOTHING * whole && whole > ROUNDED * self.longest {
            let scale = 1.0 / rest;
            for entry in &mut left {
                *entry *= scale;
            }
            // It is the column less so much of the others.
            let mut of_columns: Vec<f64> = factors.iter().map(|factor| -factor * scale).collect();
            of_columns.push(scale);
            self.directions.push((left, of_columns));
            self.columns.push((name, column));
            return None;
        }
        let beside = if whole > ROUNDED * self.longest {
            whole
        } else {
            self.longest.min(LONG)
        };
        if beside > 0.0 {
            self.nearest = self.nearest.max(rest / beside);
        }
        let parts = self.columns.iter().zip(factors);
        let parts = parts.filter_map(|(&(name, other), factor)| {
            let share = factor.abs() * length(other);
            let integer = factor.round();
            let near = (factor - integer).abs() <= ROUNDED;
            (share > ROUNDED * whole).then_some((name, if near { integer } else { factor }))
        });
        Some(parts.collect())
    }
}

fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Adds so much of another one, which may be shorter.
fn add(sum: &mut [f64], other: &[f64], factor: f64) {
    for (sum, other) in sum.iter_mut().zip(other) {
        *sum += factor * other;
    }
}
