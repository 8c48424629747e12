//! A thousand random robots with closed loops, in random orientations.
//!
//! `cargo run --release -p homogen-tests --bin mechanisms [-- --seed N] [--mechanisms N] [--only N]`
//!
//! In: a seed. Out: the largest error of each function; how many robots of each kind are right, singular or refused;
//! every failure with the text of its robot; exit status of failure if there is one.

use std::collections::BTreeMap;
use std::process::ExitCode;

use homogen_tests::mechanisms::judge::{Outcome, Worst};
use homogen_tests::mechanisms::{Trial, examine};

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
    mechanisms: usize,
    /// The index of a robot that is to be examined alone.
    only: Option<usize>,
}

impl Wanted {
    fn read(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut wanted = Self {
            seed: 1,
            mechanisms: 1000,
            only: None,
        };
        while let Some(word) = words.next() {
            let mut number = || {
                let next = words.next().and_then(|next| next.parse::<usize>().ok());
                next.ok_or_else(|| format!("{word} needs a number"))
            };
            match word.as_str() {
                "--seed" => wanted.seed = number()? as u64,
                "--mechanisms" => wanted.mechanisms = number()?,
                "--only" => wanted.only = Some(number()?),
                _ => return Err(format!("there is no option {word}")),
            }
        }
        Ok(wanted)
    }
}

fn run(wanted: &Wanted) -> ExitCode {
    let indices = match wanted.only {
        Some(only) => only..only + 1,
        None => 0..wanted.mechanisms,
    };
    let mut failures = 0;
    let mut counts: BTreeMap<String, [usize; 4]> = BTreeMap::new();
    let mut worst = Worst::new();
    for index in indices {
        let trial = Trial::numbered(wanted.seed, index);
        let name = format!(
            "{:?} in {:?}, {} digits",
            trial.kind, trial.scalar, trial.digits
        );
        let counts = counts.entry(name).or_default();
        match examine(trial) {
            Ok(Outcome::Right(errors)) => {
                counts[0] += 1;
                for (what, error) in errors {
                    let most = worst.entry(what).or_default();
                    *most = most.max(error);
                }
            }
            Ok(Outcome::Singular) => counts[1] += 1,
            Ok(Outcome::Refused) => counts[2] += 1,
            Err(message) => {
                counts[3] += 1;
                failures += 1;
                println!("{index}: {message}");
            }
        }
    }
    for (name, [right, singular, refused, failed]) in counts {
        println!(
            "{name:45} {right:4} right {singular:4} singular {refused:4} refused {failed:4} failed"
        );
    }
    for (what, error) in worst {
        println!("{what:30} {error:.1e}");
    }
    println!("{failures} failures");
    if failures == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
