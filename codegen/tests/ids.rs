//! Test that numbers of bodies, joints, links, coordinates, velocities, frames, parameters and fields have types of
//! their own: no such name is declared with a bare `usize`.
//!
//! In: the sources without their tests, and without the folders that print numbers. Out: a failure if an argument,
//! field or binding is declared so: ``velocity: usize``, or in a list of any kind ``parents: &[Option<usize>]``. A
//! count may be a `usize`: ``joints: usize``.

#[path = "sources/code.rs"]
mod sources;

use sources::code;

/// The items with numbers of their own, in the singular and the plural.
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

/// The folders that print numbers, as names and places.
const WRITERS: [&str; 1] = ["print"];

/// The types with which a line of code declares names that end in a word.
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

/// True if a line of code declares a bare number.
fn bare(line: &str) -> bool {
    NUMBERED.iter().any(|[one, many]| {
        declared(line, one).any(|of| of.contains("usize"))
            || declared(line, many).any(|of| of.contains("usize") && of.trim() != "usize")
    })
}

#[test]
fn numbers_of_items_have_types_of_their_own() {
    let mut found = Vec::new();
    for (within, lines) in code() {
        if WRITERS.iter().any(|folder| within.starts_with(folder)) {
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
fn a_bare_number_is_found() {
    assert!(bare("    pub velocity: usize,"));
    assert!(bare("let joint = |velocity: usize| velocity;"));
    assert!(bare("fn factor(parents: &[Option<usize>]) {"));
    assert!(bare("    outer_frame: usize,"));
    assert!(!bare("fn most(joints: usize, entry: usize) -> usize {"));
    assert!(!bare("    pub velocity: VelocityId,"));
    assert!(!bare("let nobody: usize = 0;"));
}
