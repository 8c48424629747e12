//! That numbers of bodies, joints, links, coordinates, velocities, frames, parameters and fields are of types of their
//! own: no name of one of them stands for a bare `usize`.
//!
//! In: the sources without their tests, and without what writes numbers out. Out: nothing where no argument, field or
//! binding is declared so: ``velocity: usize``, or in a list of any kind ``parents: &[Option<usize>]``. How many
//! there are is a `usize`: ``joints: usize``.

#[path = "sources/code.rs"]
mod sources;

use sources::code;

/// What has numbers of its own, and what many of it are called.
const NUMBERED: [[&str; 2]; 10] = [
    ["body", "bodies"],
    ["coordinate", "coordinates"],
    ["field", "fields"],
    ["frame", "frames"],
    ["joint", "joints"],
    ["leader", "leaders"],
    ["link", "links"],
    ["parameter", "parameters"],
    ["parent", "parents"],
    ["velocity", "velocities"],
];

/// The rooms that write numbers out, as names and places of what is printed.
const WRITERS: [&str; 1] = ["print"];

/// The type that a name is declared with in a line of code, wherever the name ends in one of those words.
fn declared<'l>(line: &'l str, word: &str) -> impl Iterator<Item = &'l str> {
    let places = line.match_indices(": ").filter(move |(at, _)| {
        let before = line[..*at].strip_suffix(word);
        before.is_some_and(|before| !before.ends_with(char::is_alphanumeric))
    });
    places.map(|(at, _)| {
        let from = &line[at + 2..];
        &from[..from.find([',', '=', '|', ')', ';']).unwrap_or(from.len())]
    })
}

/// What is wrong with a line of code.
fn bare(line: &str) -> bool {
    NUMBERED.iter().any(|[one, many]| {
        declared(line, one).any(|of| of.contains("usize"))
            || declared(line, many).any(|of| of.contains("usize") && of.trim() != "usize")
    })
}

#[test]
fn no_number_of_a_body_or_a_velocity_is_any_number() {
    let mut found = Vec::new();
    for (within, lines) in code() {
        if WRITERS.iter().any(|room| within.starts_with(room)) {
            continue;
        }
        let lines = lines.iter().filter(|(_, line)| bare(line));
        found.extend(
            lines.map(|(number, line)| format!("{}:{number}: {}", within.display(), line.trim())),
        );
    }
    assert!(found.is_empty(), "bare numbers:\n{}", found.join("\n"));
}

#[test]
fn a_bare_number_is_seen() {
    assert!(bare("    pub velocity: usize,"));
    assert!(bare("let joint = |velocity: usize| velocity;"));
    assert!(bare("fn factor(parents: &[Option<usize>]) {"));
    assert!(bare("    outer_frame: usize,"));
    assert!(!bare("fn most(joints: usize, entry: usize) -> usize {"));
    assert!(!bare("    pub velocity: VelocityId,"));
    assert!(!bare("let nobody: usize = 0;"));
}
