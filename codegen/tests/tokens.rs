//! Which rooms of this crate know the tokens of Rust: those that read them, ask for them or print them.
//!
//! In: the sources without their tests. Out: nothing where only those name `proc_macro2`, `quote` or
//! `syn`, and `print` beside its rooms for Rust and for Python, whose extensions are Rust, does not.

use std::fs;
use std::path::{Path, PathBuf};

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

/// The files at or below a path, without those of tests.
fn files(path: &Path) -> Vec<PathBuf> {
    if path.file_stem().is_some_and(|stem| stem == "tests") {
        return Vec::new();
    }
    let Ok(entries) = fs::read_dir(path) else {
        return vec![path.to_owned()];
    };
    let entries = entries.map(|entry| entry.expect("readable").path());
    entries.flat_map(|path| files(&path)).collect()
}

#[test]
fn what_lies_between_description_and_print_knows_no_tokens() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files(&source);
    assert!(files.len() > 100, "only {} files", files.len());
    let mut rooms = ROOMS.to_vec();
    for path in &files {
        let text = fs::read_to_string(path).expect("readable");
        let code = text.split("#[cfg(test)]\nmod tests {").next();
        let code = code.into_iter().flat_map(str::lines);
        let mut code = code.filter(|line| !line.trim().starts_with("//"));
        if !code.any(|line| {
            ["proc_macro2", "quote", "syn"]
                .iter()
                .any(|name| names(line, name))
        }) {
            continue;
        }
        let within = path.strip_prefix(&source).expect("a source");
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
