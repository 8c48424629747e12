//! Test of which folders of this crate use the tokens of Rust: those that read, request or print them.
//!
//! In: the sources without their tests. Out: a failure if another folder names `proc_macro2`, `quote` or `syn`, or if
//! `print` does beside its folders for Rust and for Python, whose extensions are Rust.

#[path = "sources/code.rs"]
mod sources;

use sources::code;

/// Files and folders that may use them.
const FOLDERS: [&str; 7] = [
    "builder",
    "description",
    "front_end",
    "error",
    "request",
    "print/python",
    "print/rust",
];

#[test]
fn stages_between_description_and_print_use_no_tokens() {
    let mut folders = FOLDERS.to_vec();
    for (within, lines) in code() {
        let mut tokens = ["proc_macro2", "quote", "syn"].iter();
        if !tokens.any(|token| lines.iter().any(|(_, line)| names(line, token))) {
            continue;
        }
        let folder = FOLDERS
            .iter()
            .find(|folder| within.with_extension("").starts_with(folder));
        let folder = folder.unwrap_or_else(|| panic!("{} knows tokens", within.display()));
        folders.retain(|other| other != folder);
    }
    assert!(folders.is_empty(), "{folders:?} know no tokens any more");
}

/// True if a line of code uses a crate.
fn names(line: &str, name: &str) -> bool {
    line.contains(&format!("{name}::")) || line.contains(&format!("{name}!"))
}
