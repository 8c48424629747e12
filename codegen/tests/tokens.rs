//! Which rooms of this crate know the tokens of Rust: those that read them, ask for them or print them.
//!
//! In: the sources without their tests. Out: nothing where only those name `proc_macro2`, `quote` or
//! `syn`, and `print` beside its rooms for Rust and for Python, whose extensions are Rust, does not.

#[path = "sources/code.rs"]
mod sources;

use sources::code;

/// Files and folders that may.
const ROOMS: [&str; 7] = [
    "builder",
    "description",
    "door",
    "error",
    "request",
    "print/python",
    "print/rust",
];

#[test]
fn what_lies_between_description_and_print_knows_no_tokens() {
    let mut rooms = ROOMS.to_vec();
    for (within, lines) in code() {
        let mut tokens = ["proc_macro2", "quote", "syn"].iter();
        if !tokens.any(|token| lines.iter().any(|(_, line)| names(line, token))) {
            continue;
        }
        let room = ROOMS
            .iter()
            .find(|room| within.with_extension("").starts_with(room));
        let room = room.unwrap_or_else(|| panic!("{} knows tokens", within.display()));
        rooms.retain(|other| other != room);
    }
    assert!(rooms.is_empty(), "{rooms:?} know no tokens any more");
}

/// Whether a line of code uses a crate.
fn names(line: &str, name: &str) -> bool {
    line.contains(&format!("{name}::")) || line.contains(&format!("{name}!"))
}
