//! Twenty thousand random robots.
//!
//! `cargo run --release -p homogen-tests --bin trees -- --long [--seed N] [--robots N] [--plain]`, or `-- --robot N`
//! for the robot whose seed a failure names; `-- --ranks --robots 2000` compares base parameters alone, of longer
//! robots in units of length from 1e-6 to 1e3 m, with ranks of regressors in 256 bits.
//!
//! In: a seed; 300 robots without `--long`; with `--plain` only robots without residues. Out: the worst error of each
//! function, every failure in the smallest robot that shows it; exit status of failure if there is one.

use std::collections::BTreeMap;
use std::panic;
use std::process::ExitCode;
use std::sync::{Arc, Mutex, PoisonError};

use homogen_tests::trees::cases::Effort;
use homogen_tests::trees::features::{FEATURES, is_plain};
use homogen_tests::trees::prepared::TOLERANCE;
use homogen_tests::trees::ranks::Ranked;
use homogen_tests::trees::{numbered, of_seed, try_ranks, try_seed};

fn main() -> ExitCode {
    match Wanted::read(std::env::args().skip(1)) {
        Ok(wanted) => run(&wanted),
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

struct Wanted {
    seed: u64,
    robots: u64,
    /// True if robots with residues are left out.
    plain: bool,
    /// True if only ranks of regressors are compared.
    ranks: bool,
    /// The seed of a robot that is to be examined alone.
    robot: Option<u64>,
}

impl Wanted {
    /// The seeds of the robots.
    fn seeds(&self) -> impl Iterator<Item = u64> {
        let run = (0..).map(|index| numbered(self.seed, index));
        let run = run.filter(|seed| !self.plain || is_plain(&of_seed(*seed)));
        let robots = if self.robot.is_some() { 0 } else { self.robots };
        let run = (0..robots).zip(run).map(|(_, seed)| seed);
        self.robot.into_iter().chain(run)
    }
}

impl Wanted {
    fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut wanted = Self {
            seed: 1,
            robots: 300,
            plain: false,
            ranks: false,
            robot: None,
        };
        let mut given = None;
        while let Some(word) = words.next() {
            let mut number = || {
                let next = words.next().and_then(|next| next.parse().ok());
                next.ok_or_else(|| format!("{word} needs a number"))
            };
            match word.as_str() {
                "--long" => wanted.robots = 20_000,
                "--plain" => wanted.plain = true,
                "--ranks" => wanted.ranks = true,
                "--seed" => wanted.seed = number()?,
                "--robot" => wanted.robot = Some(number()?),
                "--robots" => given = Some(number()?),
                _ => return Err(format!("there is no option {word}")),
            }
        }
        wanted.robots = given.unwrap_or(wanted.robots);
        Ok(wanted)
    }
}

/// Runs the tests of robots, which report panics of the engine as failures; any other panic ends the run with its
/// message.
fn run(wanted: &Wanted) -> ExitCode {
    let last = Arc::new(Mutex::new(String::new()));
    let panic_message = Arc::clone(&last);
    panic::set_hook(Box::new(move |panic| {
        *panic_message.lock().unwrap_or_else(PoisonError::into_inner) = panic.to_string();
    }));
    let test = if wanted.ranks { rank } else { examine };
    panic::catch_unwind(|| test(wanted)).unwrap_or_else(|_| {
        let last = last.lock().unwrap_or_else(PoisonError::into_inner);
        eprintln!("error: a panic outside of the engine: {last}");
        ExitCode::FAILURE
    })
}

/// The most joints of a robot whose ranks are computed.
const LONGEST: usize = 60;

/// Compares base parameters with ranks of regressors.
fn rank(wanted: &Wanted) -> ExitCode {
    let [mut right, mut refused, mut failures] = [0; 3];
    for seed in wanted.seeds() {
        match try_ranks(seed, LONGEST) {
            Ok(Ranked::Right(_)) => right += 1,
            Ok(Ranked::Refused) => {
                refused += 1;
                println!("refused by name: seed {seed}");
            }
            Err(message) => {
                failures += 1;
                println!("{message}\n");
            }
        }
        let count = right + refused + failures;
        if count % 100 == 0 {
            eprintln!("{count} robots, {failures} failures");
        }
    }
    println!("{right} ranks of regressors, {refused} refused by name, {failures} failures");
    if failures == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

fn examine(wanted: &Wanted) -> ExitCode {
    let effort = Effort {
        states: 3,
        all_up_to: 20,
    };
    let mut worst: BTreeMap<&str, (f64, u64)> = BTreeMap::new();
    let (mut failures, mut programs, mut refused) = (0, 0, 0);
    let mut counts = [0; FEATURES.len()];
    let mut done = 0;
    for seed in wanted.seeds() {
        done += 1;
        match try_seed(seed, effort) {
            Ok((robot, findings)) => {
                programs += findings.programs;
                refused += findings.refused;
                for (function, error) in findings.worst {
                    let entry = worst.entry(function).or_default();
                    if error > entry.0 {
                        *entry = (error, seed);
                    }
                }
                for (count, (_, has)) in counts.iter_mut().zip(FEATURES) {
                    *count += u32::from(has(&robot));
                }
            }
            Err(message) => {
                failures += 1;
                println!("{message}\n");
            }
        }
        if done % 1000 == 0 {
            eprintln!("{done} robots, {failures} failures");
        }
    }
    for (function, (error, seed)) in worst {
        println!("{function:24} {error:8.1e}  seed {seed}");
    }
    for (count, (name, _)) in counts.iter().zip(FEATURES) {
        println!("{count:8} robots with {name}");
    }
    println!(
        "{done} robots, {programs} programs within {TOLERANCE:e}, {refused} refused by name, {failures} failures"
    );
    if failures == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
