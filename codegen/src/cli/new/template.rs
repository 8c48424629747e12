//! The files of a crate to begin with.
//!
//! In: what stands for the words of a template. Out: texts, and a folder of them, whole or not at all. It never looks
//! at a robot.

use std::path::Path;
use std::{fs, io, process};

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
    let files = TEMPLATE.iter();
    files
        .map(|(path, text)| (*path, filled(text, words)))
        .collect()
}

fn filled(text: &str, words: &[(&str, String)]) -> String {
    // One pass: what stands for a word may look like another.
    let mut filled = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('@') {
        let (before, from) = rest.split_at(at);
        filled.push_str(before);
        let mut known = words.iter();
        if let Some((word, value)) = known.find(|(word, _)| from.starts_with(word)) {
            filled.push_str(value);
            rest = &from[word.len()..];
        } else {
            filled.push('@');
            rest = &from[1..];
        }
    }
    filled.push_str(rest);
    filled
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

#[cfg(test)]
mod tests {
    use super::filled;

    #[test]
    fn what_stands_for_a_word_is_not_looked_through() {
        let words = [("@A@", "@B@".to_owned()), ("@B@", "b".to_owned())];
        assert_eq!(filled("a@A@ @B@ @ @C@", &words), "a@B@ b @ @C@");
    }
}
