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
    stands(0..1500);
}

#[test]
fn the_second_part() {
    stands(1500..3000);
}

#[test]
fn an_input_is_the_same_on_every_machine() {
    let hash = |number| {
        let bytes = input(SEED, number).bytes;
        bytes.iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, &byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        })
    };
    let all = (0..200).fold(0_u64, |sum, number| sum.rotate_left(1) ^ hash(number));
    assert_eq!(format!("{all:016x}"), "");
}
