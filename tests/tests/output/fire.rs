//! Fuzzing with some thousands of damaged descriptions: the engine gives code or reported mistakes.
//!
//! `cargo run -p homogen-tests --bin fire -- --long` runs more, and measures time and memory.

use homogen_tests::fire::{Outcome, attempt, input};

const SEED: u64 = 10;

fn has_no_faults(numbers: std::ops::Range<u64>) {
    let count = numbers.clone().count();
    let mut refused = 0;
    let mut expanded = 0;
    let mut faults = Vec::new();
    for number in numbers {
        match attempt(SEED, number, &input(SEED, number)) {
            Ok(Outcome::Refused) => refused += 1,
            Ok(Outcome::Expanded) => expanded += 1,
            Ok(Outcome::Understood) => {}
            Err(fault) => faults.push(format!("input {number} of seed {SEED}: {fault}")),
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    println!("{count} inputs: {refused} refused, {expanded} expanded");
    // Inputs that are nearly all refused or nearly all accepted test little.
    assert!(refused * 4 > count && expanded * 20 > count);
}

#[test]
fn inputs_of_the_first_part_have_no_faults() {
    has_no_faults(0..1250);
}

#[test]
fn inputs_of_the_second_part_have_no_faults() {
    has_no_faults(1250..2500);
}
