//! Limits of time, memory and depth of an expansion, so that hostile files end with an error.

use super::failure::{Failure, failure_with_hint};

/// Maximum number of steps. A step is an element, an operation, an item of a list or eight bytes of text; an arm takes
/// thousands.
const MOST_STEPS: usize = 20_000_000;

/// Maximum depth of nested elements, macros, included files, properties and operations. A macro that calls itself takes
/// twelve levels each time; the tool allows some 300 calls.
pub(super) const MOST_LEVELS: usize = 4000;

/// The same on a stack of unknown size.
pub(super) const FEW_LEVELS: usize = 600;

/// Bytes of the stack for [`MOST_LEVELS`], several times what they take without optimisation.
pub(super) const STACK: usize = 32 << 20;

/// Levels of an element, a macro or a property, which take more of the stack than an operation.
pub(super) const HEAVY: usize = 4;

/// The steps and levels that are left.
pub(super) struct Budget {
    steps: usize,
    levels: usize,
}

impl Budget {
    /// All steps, and some levels.
    pub(super) const fn new(levels: usize) -> Self {
        Self {
            steps: MOST_STEPS,
            levels,
        }
    }

    /// Takes some steps.
    pub(super) fn spend(&mut self, steps: usize) -> Result<(), Failure> {
        if let Some(left) = self.steps.checked_sub(steps) {
            self.steps = left;
            return Ok(());
        }
        self.steps = 0;
        Err(failure_with_hint(
            "the file expands to more than a robot can have",
            "a macro or an expression repeats itself millions of times",
        ))
    }

    /// Takes the steps of a text.
    pub(super) fn spend_text(&mut self, bytes: usize) -> Result<(), Failure> {
        self.spend(bytes / 8 + 1)
    }

    /// True if nothing is left: every further step fails.
    pub(super) const fn is_spent(&self) -> bool {
        self.steps == 0
    }

    /// Goes some levels deeper.
    pub(super) fn enter(&mut self, levels: usize) -> Result<(), Failure> {
        match self.levels.checked_sub(levels) {
            Some(left) => {
                self.levels = left;
                self.spend(1)
            }
            None => Err(failure_with_hint(
                "macros, files or expressions are nested too deeply",
                "a macro calls itself or a file includes itself without end",
            )),
        }
    }

    /// Comes back from some levels.
    pub(super) const fn leave(&mut self, levels: usize) {
        self.levels += levels;
    }
}
