//! The code of this crate, for tests of rules about all of it.
//!
//! In: the sources. Out: their lines, without tests and without lines that are comments.

use std::fs;
use std::path::{Path, PathBuf};

/// For each file its path within the sources, and its lines with their numbers.
pub fn code() -> Vec<(PathBuf, Vec<(usize, String)>)> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files(&source);
    assert!(files.len() > 100, "only {} files", files.len());
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("readable");
        let code = text.split("#[cfg(test)]\nmod tests {").next();
        let lines = code.into_iter().flat_map(str::lines).zip(1..);
        let lines = lines.filter(|(line, _)| !line.trim().starts_with("//"));
        let lines = lines.map(|(line, number)| (number, line.to_owned()));
        let within = path.strip_prefix(&source).expect("a source");
        (within.to_owned(), lines.collect())
    };
    files.into_iter().map(read).collect()
}

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
