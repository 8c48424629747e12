//! Random robots: trees as vendors ship them and requests as users make them, through the whole generator, compared
//! with dense matrices of 256 bits that share nothing with it.
//!
//! In: a seed. Out: findings, or the smallest robot that fails.
//!
//! | module | does |
//! |---|---|
//! | [`grow`] | draws a [`robot`], number by number |
//! | [`text`] | writes it and has it read |
//! | [`movement`], [`dense`] | put it into dense matrices |
//! | [`cases`] | chooses the programs to run |
//! | [`prepared`], [`measure`] | run them and measure their errors |
//! | [`bounded`] | compares errors with printed bounds |
//! | [`ranks`] | compares base parameters with ranks of regressors |
//! | [`mod@examine`] | collects findings |
//! | [`mod@shrink`] | removes all that a failure does not need |
//! | [`features`] | lists the features of a robot |

pub mod bounded;
pub mod cases;
pub mod dense;
pub mod examine;
pub mod features;
pub mod grow;
pub mod measure;
pub mod movement;
pub mod prepared;
pub mod ranks;
pub mod regular;
pub mod robot;
pub mod shrink;
pub mod text;
pub mod written;

use cases::Effort;
use examine::{Fault, Findings, again, examine};
use ranks::{Ranked, ranked};
use robot::Robot;
use shrink::shrink;

use crate::states::Random;

/// Draws and examines the robot of a seed.
///
/// # Errors
/// A report with the smallest robot that fails in the same way.
pub fn try_seed(seed: u64, effort: Effort) -> Result<(Robot, Findings), String> {
    let robot = of_seed(seed);
    match examine(&robot, seed, effort) {
        Ok(findings) => Ok((robot, findings)),
        Err(fault) => Err(report(&robot, seed, effort, &fault)),
    }
}

/// Compares the base parameters of the long robot of a seed, with up to `most` joints, with the rank of its regressor.
///
/// # Errors
/// A report with the robot and the difference.
pub fn try_ranks(seed: u64, most: usize) -> Result<Ranked, String> {
    let (robot, length) = grow::grow_long(&mut Random::new(seed), most);
    ranked(&robot, length, seed)
        .map_err(|what| format!("seed {seed}, in units of {length} m: {what}\n{robot}"))
}

/// The robot of a seed.
#[must_use]
pub fn of_seed(seed: u64) -> Robot {
    grow::grow(&mut Random::new(seed))
}

/// A report of a fault, with the smallest robot that has it.
fn report(robot: &Robot, seed: u64, effort: Effort, fault: &Fault) -> String {
    let fails = |robot: &Robot| {
        (robot.options.floating || robot.moving().next().is_some())
            && again(robot, seed, effort.states, fault.case)
                .is_err_and(|what| alike(&what, &fault.what))
    };
    let least = shrink(robot, fails);
    let what = again(&least, seed, effort.states, fault.case);
    let what = what.err().unwrap_or_else(|| fault.what.clone());
    let fault = Fault {
        what,
        ..fault.clone()
    };
    format!("seed {seed}: {fault}{least}")
}

/// True if two faults are of the same kind: both are wrong numbers, or both begin with the same message.
fn alike(one: &str, other: &str) -> bool {
    let words = |what: &str| -> String {
        let is_message = ["refused", "a panic"]
            .iter()
            .any(|word| what.starts_with(word));
        let line = what
            .lines()
            .next()
            .filter(|_| is_message)
            .unwrap_or_default();
        line.chars().filter(|c| !c.is_ascii_digit()).collect()
    };
    words(one) == words(other)
}

/// The seed of robot `index` in a run.
#[must_use]
pub fn numbered(run: u64, index: u64) -> u64 {
    Random::new(run.rotate_left(32) ^ index).bits()
}
