//! Some thousands of descriptions that somebody's editor, script, disk or malice has changed: whatever
//! comes in, the stages give code or mistakes, and nothing else.
//!
//! `cargo run -p homogen-tests --bin fire -- --long` fires more, and measures.

use homogen_tests::fire::{Outcome, attempt, input};

const SEED: u64 = 10;

fn stands(numbers: std::ops::Range<u64>) {
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
    // Fire that hits everything or nothing tests nothing.
    assert!(refused * 4 > count && expanded * 20 > count);
}

#[test]
fn the_first_part() {
    stands(0..1250);
}

#[test]
fn the_second_part() {
    stands(1250..2500);
}
