//! The files of a crate to begin with.
//!
//! In: what stands for the words of a template. Out: texts, and a folder of them, whole or not at all. It never looks
//! at a robot.

use std::path::Path;
use std::{fs, io, process};

use homogen_codegen::template::filled;

/// The files, with words between `@` for what differs.
const TEMPLATE: [(&str, &str); 6] = [
    ("Cargo.toml", include_str!("firmware/manifest.toml")),
    (".cargo/config.toml", include_str!("firmware/config.toml")),
    ("README.md", include_str!("firmware/README.md.in")),
    ("build.rs", include_str!("firmware/build.rs.in")),
    ("memory.x", include_str!("firmware/memory.x")),
    ("src/main.rs", include_str!("firmware/main.rs.in")),
];

/// The files of a firmware: paths and texts.
pub(super) fn firmware(words: &[(&str, String)]) -> Vec<(&'static str, String)> {
    let words = words.iter().map(|(word, value)| (*word, value.as_str()));
    let words: Vec<_> = words.collect();
    let files = TEMPLATE.iter();
    files
        .map(|(path, text)| (*path, filled(text, &words)))
        .collect()
}

/// Writes a folder that is not there, whole or not at all.
pub(super) fn write_fresh(
    folder: &Path,
    files: &[(&str, String)],
    (description, text): (&str, &[u8]),
) -> io::Result<()> {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let fresh = folder.with_file_name(format!(".{name}.new.{}", process::id()));
    let written = || -> io::Result<()> {
        for (path, text) in files {
            let path = fresh.join(path);
            if let Some(parent) = path.parent() {
                fs::create_dir_all(parent)?;
            }
            fs::write(path, text)?;
        }
        fs::write(fresh.join(description), text)?;
        fs::rename(&fresh, folder)
    };
    written().inspect_err(|_| {
        // What is left of it is of no use, and the first reason is the one to tell.
        let _ = fs::remove_dir_all(&fresh);
    })
}
