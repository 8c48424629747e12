//! Random trees: robots as vendors ship them and as users ask for them, through the whole generator,
//! against dense matrices of 256 bits that share nothing with it.
//!
//! In: a seed. Out: what was found, or the smallest robot that fails. [`grow`] draws a [`robot`] number
//! by number; [`text`] writes it and has it read; [`movement`] knows what moves its joints, [`dense`] puts it into matrices; [`cases`] says
//! what is run, [`prepared`] runs it, [`bounded`] beside its bounds, [`measure`] how wrong it is, and [`mod@examine`] what that amounts to;
//! [`ranks`] compares base parameters with it; [`mod@shrink`] takes away what a failure does not need; [`features`] says what a robot has.

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

/// The robot of a seed, and what it shows.
///
/// # Errors
/// The smallest robot that fails as it does, in words.
pub fn try_seed(seed: u64, effort: Effort) -> Result<(Robot, Findings), String> {
    let robot = of_seed(seed);
    match examine(&robot, seed, effort) {
        Ok(findings) => Ok((robot, findings)),
        Err(fault) => Err(told(&robot, seed, effort, &fault)),
    }
}

/// The base parameters of the long robot of a seed, of up to so many joints, against its regressor.
///
/// # Errors
/// The robot and what is wrong with them, in words.
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

/// What one needs to repair a fault.
fn told(robot: &Robot, seed: u64, effort: Effort, fault: &Fault) -> String {
    let fails = |robot: &Robot| {
        (robot.asked.floating || robot.moving().next().is_some())
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

/// Whether two faults are of one kind: wrong numbers are, and refusals in the same words.
fn alike(one: &str, other: &str) -> bool {
    let words = |what: &str| -> String {
        let spoken = ["refused", "a panic"]
            .iter()
            .any(|word| what.starts_with(word));
        let line = what.lines().next().filter(|_| spoken).unwrap_or_default();
        line.chars().filter(|c| !c.is_ascii_digit()).collect()
    };
    words(one) == words(other)
}

/// The seed of a robot of a run: every run and every index has its own.
#[must_use]
pub fn numbered(run: u64, index: u64) -> u64 {
    Random::new(run.rotate_left(32) ^ index).bits()
}
