//! Differences between two lists of results, in units of rounding.
//!
//! In: blocks and their expected values, state after state. Out: the worst error of each block, as a multiple of u
//! times the largest entry that the block has in any state. A single entry may cancel and have no correct digit; the
//! largest entry measures the terms that it is a sum of.

use std::collections::BTreeMap;
use std::fmt;

use crate::functions::Block;

/// The unit roundoff of `f64`.
pub const DOUBLE: f64 = f64::EPSILON / 2.0;
/// The unit roundoff of `f32`.
pub const SINGLE: f64 = 5.960_464_477_539_063e-8;

/// The worst errors so far.
#[derive(Clone, Debug)]
pub struct Worst {
    unit: f64,
    blocks: BTreeMap<String, Extremes>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Extremes {
    error: f64,
    magnitude: f64,
}

impl Worst {
    /// No errors yet; they will be in multiples of `unit`.
    #[must_use]
    pub const fn in_units_of(unit: f64) -> Self {
        Self {
            unit,
            blocks: BTreeMap::new(),
        }
    }

    /// Adds the results of one state.
    ///
    /// # Panics
    /// If the lists differ in their blocks, or a number is not finite.
    pub fn note(&mut self, results: &[Block<f64>], expected: &[Block<f64>]) {
        assert_eq!(results.len(), expected.len(), "number of blocks");
        for (result, expected) in results.iter().zip(expected) {
            let name = &expected.name;
            assert_eq!(&result.name, name, "order of blocks");
            assert_eq!(result.entries.len(), expected.entries.len(), "{name}");
            let extremes = self.blocks.entry(name.clone()).or_default();
            for (x, y) in result.entries.iter().zip(&expected.entries) {
                assert!(x.is_finite() && y.is_finite(), "{name}: {x} for {y}");
                extremes.error = extremes.error.max((x - y).abs());
                extremes.magnitude = extremes.magnitude.max(y.abs());
            }
        }
    }

    /// Asserts that the errors of all blocks are within so many units.
    ///
    /// # Panics
    /// With a table of all blocks, if one is not.
    pub fn assert_within(&self, units: f64) {
        self.assert_each_within(|_| units);
    }

    /// Asserts that the error of each block is within the limit of its name, in units.
    ///
    /// # Panics
    /// With a table of all blocks, if one is not.
    pub fn assert_each_within(&self, limit: impl Fn(&str) -> f64) {
        assert!(!self.blocks.is_empty(), "nothing was compared");
        for (name, block) in &self.blocks {
            let limit = limit(name);
            let within = block.units(self.unit) <= limit;
            assert!(within, "{name}: more than {limit} u\n{self}");
        }
    }
}

impl Extremes {
    fn units(self, unit: f64) -> f64 {
        if self.error == 0.0 {
            0.0
        } else {
            self.error / (unit * self.magnitude)
        }
    }
}

impl fmt::Display for Worst {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, block) in &self.blocks {
            let units = block.units(self.unit);
            let Extremes { error, magnitude } = block;
            writeln!(
                out,
                "{name:24} {units:10.1} u  ({error:.1e} of {magnitude:.1e})"
            )?;
        }
        Ok(())
    }
}
