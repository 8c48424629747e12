//! The messages of the guide's page on troubleshooting, compared with those that users get.
//!
//! In: the page, pinned messages of the compiler, and the sources of engine and runtime. Each message of a table must be
//! one of theirs.

use std::fs;
use std::path::{Path, PathBuf};

const PAGE: &str = include_str!("../../guide/src/troubleshooting.md");

/// Pinned messages, and the sources that hold messages.
fn texts() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut folders: Vec<PathBuf> = [
        "tests/rejection/tests/rejected",
        "codegen/src",
        "runtime/src",
    ]
    .map(|folder| root.join(folder))
    .to_vec();
    let mut all = String::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the folder is there") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                folders.push(path);
            } else if (path.extension()).is_some_and(|end| end == "stderr" || end == "rs") {
                all += &fs::read_to_string(path).expect("text");
            }
        }
    }
    all
}

/// True if a line has the parts of a message between its dots, in order.
fn has(line: &str, message: &str) -> bool {
    let mut rest = line;
    message.split('…').all(|part| {
        let found = rest.split_once(part);
        rest = found.map_or("", |(_, after)| after);
        found.is_some()
    })
}

#[test]
fn each_message_exists() {
    let texts = texts();
    let mut tables = 0;
    let mut is_of_messages = false;
    for line in PAGE.lines() {
        if line.starts_with("| message |") {
            (tables, is_of_messages) = (tables + 1, true);
        } else if !line.starts_with('|') {
            is_of_messages = false;
        } else if is_of_messages {
            let cell = line.split(" | ").next().expect("a cell");
            let (mark, cell) = match cell.split_once("``") {
                Some((_, message)) => ("``", message.trim_end_matches('`').to_owned()),
                None => ("`", cell.to_owned()),
            };
            let messages: Vec<&str> = match mark {
                "``" => vec![&cell],
                _ => cell.split('`').skip(1).step_by(2).collect(),
            };
            for message in messages {
                let found = texts.lines().any(|line| has(line, message));
                assert!(found, "no such message: {message}");
            }
        }
    }
    assert!(tables > 5, "{tables} tables of messages");
}
