//! Random robots through the whole generator, compared with dense matrices of 256 bits: see [`homogen_tests::trees`].
//! `cargo run --release -p homogen-tests --bin trees -- --long` runs twenty thousand.

use std::collections::BTreeMap;

use homogen_codegen::Function;
use homogen_tests::effort::effort;
use homogen_tests::trees::cases::Effort;
use homogen_tests::trees::examine::together;
use homogen_tests::trees::features::FEATURES;
use homogen_tests::trees::prepared::TOLERANCE;
use homogen_tests::trees::ranks::Ranked;
use homogen_tests::trees::{numbered, of_seed, try_ranks, try_seed};
use rayon::prelude::*;

/// Robots that are drawn: every fourth one is compared, in the long form all of them.
const ROBOTS: u64 = 150;

/// The robots that are compared.
fn compared() -> impl Iterator<Item = u64> {
    (0..ROBOTS).step_by(effort(4, 1))
}

const RUN: u64 = 0;

const EFFORT: Effort = Effort {
    states: 2,
    all_up_to: 4,
};

/// On all cores: some robots take ten times as long as others.
#[test]
fn every_function_of_random_robots_is_right() {
    let robots: Vec<u64> = compared().collect();
    let examined = (robots.into_par_iter().with_max_len(1))
        .map(|index| try_seed(numbered(RUN, index), EFFORT).map(|(_, findings)| findings));
    let examined: Vec<_> = examined.collect();
    let mut worst: BTreeMap<&str, f64> = BTreeMap::new();
    let mut failures = Vec::new();
    let mut programs = 0;
    for found in examined {
        match found {
            Ok(findings) => {
                programs += findings.programs;
                for (function, error) in findings.worst {
                    let entry = worst.entry(function).or_default();
                    *entry = entry.max(error);
                }
            }
            Err(message) => failures.push(message),
        }
    }
    for (function, error) in worst {
        println!("{function:24} {error:.1e}");
    }
    println!("{programs} programs");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn base_parameters_of_30_robots_are_as_many_as_the_rank() {
    let seeds = (0..30).map(|index| numbered(RUN, index));
    let found = seeds.map(|seed| try_ranks(seed, 6).unwrap_or_else(|what| panic!("{what}")));
    let right = found.filter(|found| matches!(found, Ranked::Right(_)));
    let right = right.count();
    assert!(right >= 20, "{right} of 30");
}

#[test]
fn functions_generated_together_are_right() {
    let functions = [
        Function::MassMatrix,
        Function::InverseDynamics,
        Function::Gravity,
        Function::Bias,
    ];
    for index in 0..30 {
        let seed = numbered(RUN, index);
        let robot = of_seed(seed);
        let error = together(&robot, seed, EFFORT.states, &functions);
        let error = error.unwrap_or_else(|what| panic!("{what}\n{robot}"));
        assert!(error < TOLERANCE, "seed {seed}: {error:.1e}\n{robot}");
    }
}

/// No feature can disappear from random robots unnoticed.
#[test]
fn every_feature_occurs() {
    let robots: Vec<_> = compared()
        .map(|index| of_seed(numbered(RUN, index)))
        .collect();
    for (name, has) in FEATURES {
        let count = robots.iter().filter(|robot| has(robot)).count();
        println!("{count:4} robots with {name}");
        assert!(count >= effort(1, 3), "{count} robots with {name}");
    }
}
