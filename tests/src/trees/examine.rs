//! Comparison of all functions of a random robot with the oracle.
//!
//! In: a [`Robot`]. Out: the worst error of each function, or the first [`Fault`]: a wrong program, a rejected
//! description, a panic. [`cases`] chooses the programs, and [`Prepared`] measures their errors.

use std::collections::BTreeMap;
use std::fmt;

use homogen_codegen::Function;

use super::cases::{Case, Effort, cases};
use super::prepared::{Outcome, Prepared};
use super::robot::Robot;

/// A failure of a robot.
#[derive(Clone, Debug)]
pub struct Fault {
    /// The program that is wrong; `None` if the chain could not be built.
    pub case: Option<Case>,
    /// A description of the failure.
    pub what: String,
}

/// Results of a robot without a failure.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// The worst error of each function, by name.
    pub worst: BTreeMap<&'static str, f64>,
    /// The number of programs that ran.
    pub programs: usize,
    /// The number of programs that were refused by name.
    pub refused: usize,
}

/// Runs every function of a robot.
///
/// # Errors
/// The first fault.
pub fn examine(robot: &Robot, seed: u64, effort: Effort) -> Result<Findings, Fault> {
    let prepared =
        Prepared::of(robot, seed, effort.states).map_err(|what| Fault { case: None, what })?;
    let mut findings = Findings::default();
    for case in cases(prepared.chain(), seed, effort) {
        let outcome = prepared.check(case).map_err(|what| Fault {
            case: Some(case),
            what,
        })?;
        match outcome {
            Outcome::Refused => findings.refused += 1,
            Outcome::Within(error) => {
                findings.programs += 1;
                let worst = findings.worst.entry(case.function.name()).or_default();
                *worst = worst.max(error);
            }
            Outcome::NotApplicable => {}
        }
    }
    Ok(findings)
}

/// Runs one program of a robot again.
///
/// # Errors
/// A description of the failure.
pub fn again(robot: &Robot, seed: u64, states: usize, case: Option<Case>) -> Result<(), String> {
    let prepared = Prepared::of(robot, seed, states)?;
    case.map_or(Ok(()), |case| prepared.check(case).map(|_| ()))
}

/// The worst error of functions that are generated together and share work.
///
/// # Errors
/// A description of the failure.
pub fn together(
    robot: &Robot,
    seed: u64,
    states: usize,
    functions: &[Function],
) -> Result<f64, String> {
    Prepared::of(robot, seed, states)?.together(functions)
}

impl fmt::Display for Fault {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.case {
            Some(case) => writeln!(out, "{case}: {}", self.what),
            None => writeln!(out, "{}", self.what),
        }
    }
}
