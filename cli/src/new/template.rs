//! The files of a new crate: replaces the words of a template, and writes a folder completely or not at all.

use std::path::Path;
use std::{fs, io, process};

use homogen_codegen::template::filled;

/// The files, with words between `@` to be replaced.
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

/// Writes a new folder completely or not at all.
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
        // The rest is useless, and the first error is the one to report.
        let _ = fs::remove_dir_all(&fresh);
    })
}
