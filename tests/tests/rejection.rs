//! What the compiler shows for a mistake: one error each, under the word that caused it, and nothing
//! else, though every file goes on to call the functions it asked for.
//!
//! One file a mistake in `rejected/`, with what is shown beside it, and the descriptions it names.

use std::fs;
use std::path::{Path, PathBuf};

/// The files in `rejected/` that end so.
fn files(ending: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/rejected");
    let entries = fs::read_dir(folder).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("it can be read").path());
    paths
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == ending)
        })
        .collect()
}

/// Puts the descriptions where paths in macros begin: in the folder of the package that `trybuild`
/// makes of all the files.
fn place_descriptions() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let target = target
        .parent()
        .expect("it lies in the folder of all that is built");
    let package = target.join("tests/trybuild/homogen-tests/rejected");
    fs::create_dir_all(&package).expect("a folder to build in");
    for file in files("urdf") {
        let name = file.file_name().expect("a file");
        fs::copy(&file, package.join(name)).expect("a file that can be copied");
    }
}

#[test]
fn mistakes_are_shown_where_they_are() {
    place_descriptions();
    trybuild::TestCases::new().compile_fail("tests/rejected/*.rs");
}

#[test]
fn no_mistake_drags_others_behind_it() {
    let shown = files("stderr");
    assert_eq!(shown.len(), files("rs").len());
    for file in shown {
        let text = fs::read_to_string(&file).expect("text");
        let lines = || text.lines().filter(|line| line.starts_with("error"));
        assert!(lines().count() > 0, "{}", file.display());
        // The compiler's own errors have a number.
        assert!(lines().all(|line| line.starts_with("error: ")), "{text}");
    }
}
