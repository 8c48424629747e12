//! Error bounds of a free fall, and of what is added to it.
//!
//! In: a program for the acceleration f of a falling base and its derivatives, in a range. Out: the range of
//! accelerations relative to f, and the rounding errors of f and of its sums with them, as accelerations.

use super::error_bounds::{RoundingModel, computed, values};
use crate::range::Range;
use crate::real::Real;
use crate::schedule::Program;
use crate::schedule::bound::Value;
use crate::space::Variable;

/// The values of a free fall; zeros if the base is fixed.
pub(super) struct FreeFall {
    roundoff: f64,
    /// f.
    acceleration: Vec<Value>,
    /// ∂f/∂q and ∂f/∂q̇, by rows.
    derivatives: Vec<Value>,
}

impl FreeFall {
    /// # Errors
    /// If a value has no bound.
    pub(super) fn of(
        program: &Program,
        range: &Range,
        rounding: RoundingModel,
        scalar: Real,
    ) -> Result<Self, &'static str> {
        let mut acceleration = values(computed(program, range, rounding, scalar))?;
        let derivatives = acceleration.split_off(range.arguments[Variable::Qdd].len());
        Ok(Self {
            roundoff: scalar.roundoff(),
            acceleration,
            derivatives,
        })
    }

    /// A range with accelerations relative to f.
    pub(super) fn relative(&self, range: &Range) -> Range {
        let mut relative = range.clone();
        let ends = relative.arguments[Variable::Qdd].iter_mut();
        for ([least, most], fall) in ends.zip(&self.acceleration) {
            *least -= fall.reach();
            *most += fall.reach();
        }
        relative
    }

    /// The errors of accelerations by those of f and of the sums, in a range of relative accelerations.
    pub(super) fn lost(&self, relative: &Range) -> Vec<f64> {
        let sizes = relative.arguments[Variable::Qdd]
            .iter()
            .map(|[_, most]| *most);
        let falls = self.acceleration.iter().zip(sizes);
        falls.map(|(fall, size)| self.of_sum(fall, size)).collect()
    }

    /// The same of the derivatives by q and q̇, by rows, for the largest magnitudes of each row of the relative ones.
    pub(super) fn lost_in_derivatives(&self, sizes: &[f64]) -> Vec<f64> {
        let count = sizes.len();
        let falls = self.derivatives.iter().enumerate();
        falls
            .map(|(k, fall)| self.of_sum(fall, sizes[k / count % count]))
            .collect()
    }

    /// The error of the sum of a value with a number of at most a size; none if the value is zero.
    fn of_sum(&self, fall: &Value, size: f64) -> f64 {
        if fall.reach() == 0.0 {
            0.0
        } else {
            fall.error + self.roundoff * (fall.reach() + fall.error + size)
        }
    }
}

/// The errors of torques that errors of derivatives of accelerations are worth, entry by entry of matrices by rows;
/// `mass` has the magnitudes of M.
pub(super) fn torques(lost: &[f64], count: usize, mass: impl Fn(usize, usize) -> f64) -> Vec<f64> {
    let rows: Vec<usize> = (0..count)
        .filter(|row| {
            let entries = lost.chunks(count).skip(*row).step_by(count);
            entries.flatten().any(|lost| *lost > 0.0)
        })
        .collect();
    let entry = |k: usize| {
        let (matrix, row, column) = (k / count / count, k / count % count, k % count);
        let terms = rows
            .iter()
            .map(|&of| mass(row, of) * lost[(matrix * count + of) * count + column]);
        terms.sum()
    };
    (0..lost.len()).map(entry).collect()
}
