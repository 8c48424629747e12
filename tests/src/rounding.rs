//! How far two lists of results are apart, in units of rounding.
//!
//! In: blocks and what they should be, state after state. Out: the worst error of each block, as a
//! multiple of u times the largest entry that the block has in any state. A single entry may
//! cancel to nothing, and then has no digits to agree on; the block says how large the numbers are
//! that it was summed from.

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
    /// No errors yet, to be told in multiples of `unit`.
    #[must_use]
    pub const fn in_units_of(unit: f64) -> Self {
        Self {
            unit,
            blocks: BTreeMap::new(),
        }
    }

    /// Takes in the results of one state.
    ///
    /// # Panics
    /// Where the two lists have not the same blocks, or a number is not finite.
    pub fn note(&mut self, results: &[Block<f64>], expected: &[Block<f64>]) {
        assert_eq!(results.len(), expected.len(), "as many blocks");
        for (result, expected) in results.iter().zip(expected) {
            let name = &expected.name;
            assert_eq!(&result.name, name, "blocks in the same order");
            assert_eq!(result.entries.len(), expected.entries.len(), "{name}");
            let extremes = self.blocks.entry(name.clone()).or_default();
            for (x, y) in result.entries.iter().zip(&expected.entries) {
                assert!(x.is_finite() && y.is_finite(), "{name}: {x} for {y}");
                extremes.error = extremes.error.max((x - y).abs());
                extremes.magnitude = extremes.magnitude.max(y.abs());
            }
        }
    }

    /// Every block must be right to within so many units.
    ///
    /// # Panics
    /// With a table of all blocks, where one is not.
    pub fn assert_within(&self, units: f64) {
        self.assert_each_within(|_| units);
    }

    /// Every block must be right to within as many units as a block of its name may be off.
    ///
    /// # Panics
    /// With a table of all blocks, where one is not.
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
