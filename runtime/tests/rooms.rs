//! The rooms of this crate: each names those above it in the front page's table, and none below.
//!
//! In: the sources. Out: nothing where `crate::` in code is followed by a room that may be named. It
//! does not see what is named by way of `super`.

use std::fs;
use std::path::{Path, PathBuf};

/// Each room with those it may name besides itself; a room without a folder is a file. The macro
/// `every_function` is of `robot`, although exported ones are named from the root.
const ROOMS: [(&str, &[&str]); 9] = [
    ("scalar", &[]),
    ("error", &["scalar"]),
    ("matrix", &["scalar", "error"]),
    ("robot", &["scalar", "error", "matrix"]),
    ("paper", &["scalar", "error", "matrix", "robot"]),
    ("reference", &["matrix", "robot", "every_function"]),
    ("ik", &["scalar", "error", "matrix", "robot"]),
    ("identify", &["scalar", "paper"]),
    ("batch", &["scalar", "matrix", "robot", "every_function"]),
];

/// The files at or below a path, with the room that each is in.
fn files(path: &Path, room: &str) -> Vec<(String, PathBuf)> {
    let entries = fs::read_dir(path).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("readable").path());
    paths
        .flat_map(|path| {
            let stem = path.file_stem().and_then(|stem| stem.to_str());
            let stem = stem.expect("a name").to_owned();
            let room = if room.is_empty() { &stem } else { room };
            if path.is_dir() {
                files(&path, room)
            } else {
                vec![(room.to_owned(), path)]
            }
        })
        .filter(|(_, path)| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}

#[test]
fn a_room_names_those_above_it_alone() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files(&source, "");
    assert!(files.len() > 30, "only {} files", files.len());
    for (room, path) in files.iter().filter(|(room, _)| room != "lib") {
        let known = ROOMS.iter().find(|(name, _)| name == room);
        let (_, above) = known.unwrap_or_else(|| panic!("{} is in no room", path.display()));
        let text = fs::read_to_string(path).expect("readable");
        // What a macro writes by `$crate::` is of the room that calls it.
        let text = text.replace("$crate::", "");
        let code = text.lines().filter(|line| !line.trim().starts_with("//"));
        for named in code.flat_map(|line| line.split("crate::").skip(1)) {
            let end = named.find(|c: char| !c.is_alphanumeric() && c != '_');
            let named = &named[..end.unwrap_or(named.len())];
            assert!(
                named == room || above.contains(&named),
                "{} names `{named}`",
                path.display()
            );
        }
    }
}
