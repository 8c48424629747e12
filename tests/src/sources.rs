//! Sources of the engine without comments and tests, for tests that forbid something in them.
//!
//! In: the files below `codegen/src`. Out: the code of each, with its path.

use std::fs;
use std::path::{Path, PathBuf};

/// A file of the engine.
#[derive(Debug)]
pub struct Source {
    /// Its path below `codegen/src`, with slashes.
    pub name: String,
    /// Its code, line by line.
    pub code: String,
}

/// All files of the engine, without tests.
///
/// # Panics
/// If a file cannot be read.
#[must_use]
pub fn engine() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../codegen/src");
    let mut files = Vec::new();
    find(&root, &mut files);
    let sources = files.iter().map(|file| {
        let name = file.strip_prefix(&root).expect("it lies there");
        Source {
            name: name.to_string_lossy().replace('\\', "/"),
            code: code(&fs::read_to_string(file).expect("text")),
        }
    });
    sources.collect()
}

/// A text without its module of tests and its lines of comments.
#[must_use]
pub fn code(text: &str) -> String {
    let code = text.split("#[cfg(test)]\nmod tests {").next();
    let lines = code.unwrap_or_default().lines();
    let lines = lines.filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

fn find(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.file_stem().is_some_and(|stem| stem == "tests") {
            continue;
        }
        if path.is_dir() {
            find(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
}
