//! Files that somebody's editor, script or disk has damaged: whatever comes in, the stages give code
//! or mistakes, and never panic.
//!
//! The robots that ship are changed at random, with a seed: bytes lost, lines lost, repeated or
//! swapped, numbers and words replaced by such as break readers. Most results are no robots; that
//! some still are is checked, so that the later stages have their share.

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

use homogen_codegen::description::{Name, read_bytes};
use homogen_codegen::emit::{self, Item};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::request::Request;
use homogen_codegen::{Function, chain};
use homogen_tests::states::Random;
use quote::format_ident;

/// Files made of each robot.
const FILES: usize = 200;

/// What takes the place of a word or a number.
const SPLINTERS: [&str; 24] = [
    "", "0", "-0", "1e999", "-1e-999", "1e308", "5e-324", "nan", "inf", "1.5708", "0 0", "0 0 0",
    "1 0 0 0", "x", "fn", "base", "link1", "revolute", "fixed", "floating", "\"", "<", "&",
    "é\u{0}",
];

/// Where a stretch of the text between two bytes of a kind begins and ends.
fn stretch(text: &[u8], random: &mut Random, is: fn(u8) -> bool) -> std::ops::Range<usize> {
    let at = random.below(text.len());
    let start = text[..at]
        .iter()
        .rposition(|&byte| is(byte))
        .map_or(0, |k| k + 1);
    let end = text[at..]
        .iter()
        .position(|&byte| is(byte))
        .map_or(text.len(), |k| at + k);
    start.min(end)..end
}

/// The text with one thing wrong with it.
fn damaged(mut text: Vec<u8>, random: &mut Random) -> Vec<u8> {
    let line = |text: &[u8], random: &mut Random| stretch(text, random, |byte| byte == b'\n');
    let word = |text: &[u8], random: &mut Random| stretch(text, random, |byte| byte == b'"');
    if text.is_empty() {
        return text;
    }
    match random.below(8) {
        0 => {
            let k = random.below(text.len());
            text[k] = random.bits().to_le_bytes()[0];
        }
        1 => drop(text.drain(line(&text, random))),
        2 => {
            let copied = text[line(&text, random)].to_vec();
            let to = line(&text, random).end;
            text.splice(to..to, copied);
        }
        3 => {
            let cut = random.below(text.len());
            text.truncate(cut);
        }
        // What stands between two quotes, or between what is in quotes: mostly values and names.
        4 | 5 => {
            let splinter = random.choose(&SPLINTERS).bytes();
            text.splice(word(&text, random), splinter);
        }
        6 => {
            let other = text[word(&text, random)].to_vec();
            text.splice(word(&text, random), other);
        }
        _ => {
            let at = stretch(&text, random, |byte| !byte.is_ascii_digit());
            text.splice(at, random.choose(&SPLINTERS).bytes());
        }
    }
    text
}

fn request(random: &mut Random, links: &[Name], joints: &[Name]) -> Request {
    let mut request = Request {
        functions: vec![vec![*random.choose(&Function::ALL)]],
        strict: random.chance(8),
        exact: random.chance(4),
        path_only: random.chance(8),
        ..Request::default()
    };
    if let Some(tip) = links.last().filter(|_| !random.chance(4)) {
        request.tip = Some(tip.clone());
    }
    if !links.is_empty() && random.chance(8) {
        request.drop.push(random.choose(links).clone());
        request.base = Some(random.choose(links).clone());
    }
    if !joints.is_empty() && random.chance(8) {
        request.lock.push((random.choose(joints).clone(), None));
    }
    request
}

/// Takes the bytes as far as they go; whether that is to the end.
fn expands(bytes: &[u8], random: &mut Random) -> bool {
    let mut errors = Errors::new();
    let Some(description) = read_bytes(bytes, "arm.urdf", None, &mut errors) else {
        assert!(!errors.is_empty(), "nothing was read, and nothing said");
        return false;
    };
    let links: Vec<Name> = description
        .links
        .iter()
        .map(|link| link.name.clone())
        .collect();
    let joints: Vec<Name> = description
        .joints
        .iter()
        .map(|joint| joint.name.clone())
        .collect();
    let request = request(random, &links, &joints);
    // What was misread goes no further in a door, but must do no harm to the chain.
    let built = chain::build(&description, &request);
    if !errors.is_empty() {
        return false;
    }
    match expand(&description, &request, Item::made(format_ident!("Arm"))) {
        Ok(listing) => {
            assert!(built.is_ok());
            !emit::emit(&listing).is_empty()
        }
        Err(errors) => {
            assert!(!errors.is_empty(), "no code, and nothing said");
            false
        }
    }
}

fn stand(robot: &str, seed: u64) {
    let path = format!("{}/../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"));
    let original = fs::read(path).expect("the robot is there");
    let mut random = Random::new(seed);
    let mut expanded = 0;
    for number in 0..FILES {
        let mut text = original.clone();
        for _ in 0..=random.below(3) {
            text = damaged(text, &mut random);
        }
        let outcome = catch_unwind(AssertUnwindSafe(|| expands(&text, &mut random)));
        let text = || String::from_utf8_lossy(&text);
        let code = outcome.unwrap_or_else(|_| panic!("file {number}:\n{}", text()));
        expanded += usize::from(code);
    }
    println!("{expanded} of {FILES} still are robots");
    assert!(expanded > 0 && expanded < FILES);
}

#[test]
fn two_links() {
    stand("two_link", 1);
}

#[test]
fn a_scara() {
    stand("scara", 2);
}

#[test]
fn an_arm_with_many_zeros() {
    stand("stanford", 3);
}

#[test]
fn an_arm_with_full_tensors() {
    stand("panda_class", 4);
}

#[test]
fn a_tree() {
    stand("quadruped", 5);
}
