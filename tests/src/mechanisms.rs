//! Random robots with closed loops, in any orientation, through the whole generator, compared with equations of motion
//! in 256 bits.
//!
//! In: a seed. Out: the outcome, or an error with the robot's text. [`draw`](mod@draw) chooses points and axes,
//! [`text`](mod@text) mounts and writes the robot, [`programs`] generates it and closes its loops, [`truth`] solves its
//! equations, and [`judge`](mod@judge) compares.

pub mod draw;
pub mod judge;
pub mod programs;
pub mod space;
pub mod text;
pub mod truth;

use std::panic::{AssertUnwindSafe, catch_unwind};

use homogen_codegen::Real;

use crate::states::Random;
use draw::{Kind, draw};
use judge::{Outcome, judge};
use text::{Mounting, text};

/// Decimal digits of the numbers in files.
pub const DIGITS: [usize; 4] = [17, 16, 6, 3];

/// A test case.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// The kind of the robot.
    pub kind: Kind,
    /// Decimal digits of its numbers.
    pub digits: usize,
    /// The scalar type.
    pub scalar: Real,
    /// The seed of all other choices.
    pub seed: u64,
}

impl Trial {
    /// The test case of an index in a run; kinds, digits and types alternate.
    #[must_use]
    pub fn numbered(run: u64, index: usize) -> Self {
        let kinds = Kind::ALL.len();
        let cycle = index / kinds;
        Self {
            kind: Kind::ALL[index % kinds],
            digits: DIGITS[cycle % DIGITS.len()],
            scalar: if (cycle / DIGITS.len()) % 3 == 2 {
                Real::F32
            } else {
                Real::F64
            },
            seed: Random::new(run.rotate_left(32) ^ index as u64).bits(),
        }
    }
}

/// Draws, writes, generates and judges a robot.
///
/// # Errors
/// The failure, with the text of the robot.
pub fn examine(trial: Trial) -> Result<Outcome, String> {
    let mut random = Random::new(trial.seed);
    let mechanism = draw(trial.kind, &mut random);
    let mounting = Mounting::any(&mechanism, trial.digits, &mut random);
    let judged = AssertUnwindSafe(|| judge(&mechanism, &mounting, trial.scalar, &mut random));
    let outcome = catch_unwind(judged).unwrap_or_else(|_| Err("a panic".to_owned()));
    outcome.map_err(|what| format!("{trial:?}: {what}\n{}", text(&mechanism, &mounting)))
}
