//! Random mechanisms in any orientation, through the whole generator, against equations of motion in 256 bits.
//!
//! In: a seed. Out: what became of the mechanism, or what is wrong, with its text. [`draw`](mod@draw) says where its joints are,
//! [`text`](mod@text) mounts and writes it, [`programs`] generates it and closes its loops, [`truth`] solves its equations, and
//! [`judge`](mod@judge) compares.

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

/// How many digits numbers have in files.
pub const DIGITS: [usize; 4] = [17, 16, 6, 3];

/// What is asked of a seed.
#[derive(Clone, Copy, Debug)]
pub struct Trial {
    /// The kind of the mechanism.
    pub kind: Kind,
    /// How many digits its numbers have.
    pub digits: usize,
    /// The type of number.
    pub scalar: Real,
    /// The seed of everything else.
    pub seed: u64,
}

impl Trial {
    /// That of an index in a run: kinds take turns, and so do digits.
    #[must_use]
    pub fn numbered(run: u64, index: usize) -> Self {
        let kinds = Kind::ALL.len();
        let round = index / kinds;
        Self {
            kind: Kind::ALL[index % kinds],
            digits: DIGITS[round % DIGITS.len()],
            scalar: if (round / DIGITS.len()) % 3 == 2 {
                Real::F32
            } else {
                Real::F64
            },
            seed: Random::new(run.rotate_left(32) ^ index as u64).bits(),
        }
    }
}

/// What becomes of a mechanism.
///
/// # Errors
/// What is wrong, with the text.
pub fn examine(trial: Trial) -> Result<Outcome, String> {
    let mut random = Random::new(trial.seed);
    let mechanism = draw(trial.kind, &mut random);
    let mounting = Mounting::any(&mechanism, trial.digits, &mut random);
    let judged = AssertUnwindSafe(|| judge(&mechanism, &mounting, trial.scalar, &mut random));
    let outcome = catch_unwind(judged).unwrap_or_else(|_| Err("a panic".to_owned()));
    outcome.map_err(|what| format!("{trial:?}: {what}\n{}", text(&mechanism, &mounting)))
}
