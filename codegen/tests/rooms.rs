//! Test of the dependences between the folders of this crate: each uses only those before it in a list.
//!
//! In: the sources without their tests. Out: a failure if `crate::` in code is followed by a folder that may not be
//! named. Uses by way of a method are not seen.

use std::fs;
use std::path::{Path, PathBuf};

/// Each folder with those it may name besides itself: first the shared types, then the stages in the order of `expand`,
/// then the front ends.
const FOLDERS: [(&str, &[&str]); 37] = [
    ("wording", &[]),
    ("list", &[]),
    ("template", &[]),
    ("index", &[]),
    ("random", &[]),
    ("real", &[]),
    ("error", &["wording"]),
    ("space", &["list"]),
    ("expression", &["list", "index", "space"]),
    ("number", &["error", "expression"]),
    ("name", &["error"]),
    ("matrix", &["expression"]),
    (
        "joint",
        &["real", "space", "expression", "number", "matrix"],
    ),
    ("quaternion", &["real", "expression"]),
    ("arithmetic", &["real", "expression"]),
    ("closure", &["space", "number"]),
    ("processor", &["wording", "real"]),
    ("formulation", &["wording"]),
    ("simplify", &["expression"]),
    (
        "dense",
        &["list", "space", "expression", "joint", "closure"],
    ),
    (
        "schedule",
        &["index", "real", "space", "expression", "processor"],
    ),
    (
        "function",
        &[
            "list",
            "space",
            "expression",
            "matrix",
            "formulation",
            "dense",
        ],
    ),
    (
        "request",
        &[
            "wording",
            "real",
            "error",
            "number",
            "name",
            "joint",
            "processor",
            "formulation",
            "schedule",
            "function",
        ],
    ),
    (
        "description",
        &[
            "wording",
            "list",
            "real",
            "error",
            "expression",
            "number",
            "name",
            "joint",
            "closure",
            "processor",
            "formulation",
            "function",
            "request",
        ],
    ),
    (
        "chain",
        &[
            "wording",
            "list",
            "random",
            "error",
            "space",
            "expression",
            "number",
            "matrix",
            "joint",
            "closure",
            "dense",
            "function",
            "request",
            "description",
        ],
    ),
    (
        "convert",
        &[
            "wording",
            "list",
            "error",
            "expression",
            "number",
            "joint",
            "closure",
            "request",
            "description",
            "chain",
        ],
    ),
    (
        "layout",
        &[
            "list",
            "space",
            "expression",
            "matrix",
            "joint",
            "closure",
            "chain",
        ],
    ),
    (
        "model",
        &[
            "list",
            "real",
            "space",
            "expression",
            "matrix",
            "joint",
            "closure",
            "formulation",
            "chain",
            "layout",
        ],
    ),
    ("range", &["list", "space", "expression", "chain"]),
    (
        "plan",
        &[
            "wording",
            "list",
            "random",
            "real",
            "error",
            "space",
            "expression",
            "quaternion",
            "processor",
            "formulation",
            "simplify",
            "schedule",
            "function",
            "request",
            "chain",
            "layout",
            "model",
            "range",
        ],
    ),
    (
        "accuracy",
        &[
            "list",
            "real",
            "space",
            "expression",
            "joint",
            "formulation",
            "schedule",
            "function",
            "request",
            "chain",
            "layout",
            "model",
            "range",
            "plan",
        ],
    ),
    (
        "module",
        &[
            "real",
            "error",
            "space",
            "joint",
            "closure",
            "formulation",
            "schedule",
            "function",
            "request",
            "description",
            "layout",
            "accuracy",
        ],
    ),
    (
        "check",
        &[
            "wording",
            "list",
            "random",
            "real",
            "error",
            "space",
            "expression",
            "matrix",
            "joint",
            "quaternion",
            "dense",
            "schedule",
            "function",
            "request",
            "description",
            "chain",
            "plan",
            "accuracy",
            "module",
        ],
    ),
    (
        "print",
        &[
            "wording",
            "list",
            "template",
            "real",
            "space",
            "expression",
            "number",
            "joint",
            "closure",
            "processor",
            "formulation",
            "schedule",
            "function",
            "request",
            "accuracy",
            "module",
        ],
    ),
    (
        "expand",
        &[
            "wording",
            "list",
            "random",
            "real",
            "error",
            "space",
            "expression",
            "matrix",
            "joint",
            "quaternion",
            "closure",
            "formulation",
            "schedule",
            "function",
            "request",
            "description",
            "chain",
            "layout",
            "model",
            "plan",
            "accuracy",
            "module",
            "check",
        ],
    ),
    (
        "builder",
        &[
            "wording",
            "real",
            "error",
            "joint",
            "processor",
            "formulation",
            "function",
            "request",
            "description",
            "chain",
            "module",
            "print",
            "expand",
        ],
    ),
    (
        "front_end",
        &[
            "error",
            "space",
            "function",
            "description",
            "module",
            "print",
            "expand",
        ],
    ),
];

/// The only exceptions: definitions of functions are used by all stages, and contain how the model computes them.
const UP: [(&str, &str); 3] = [
    ("function", "chain"),
    ("function", "layout"),
    ("function", "model"),
];

/// The files at or below a path, each with its folder.
fn files(path: &Path, folder: &str) -> Vec<(String, PathBuf)> {
    let entries = fs::read_dir(path).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("readable").path());
    paths
        .flat_map(|path| {
            let stem = path.file_stem().and_then(|stem| stem.to_str());
            let stem = stem.expect("a name").to_owned();
            let folder = if folder.is_empty() { &stem } else { folder };
            if path.is_dir() {
                files(&path, folder)
            } else {
                vec![(folder.to_owned(), path)]
            }
        })
        .filter(|(_, path)| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}

/// True for a file of tests.
fn is_of_tests(path: &Path) -> bool {
    let mut parts = path.iter().filter_map(|part| part.to_str());
    parts.any(|part| ["tests", "tests.rs", "long_chains.rs"].contains(&part))
}

/// The folders that the code of a file names, without its module of tests.
fn named(text: &str) -> Vec<&str> {
    let code = text
        .split("#[cfg(test)]\nmod tests {")
        .next()
        .unwrap_or_default();
    let lines = code.lines().filter(|line| !line.trim().starts_with("//"));
    let paths = lines.flat_map(|line| {
        let paths = line
            .match_indices("crate::")
            .map(|(at, _)| (&line[..at], &line[at + 7..]));
        // A path in a macro, or in printed code, belongs to another crate.
        paths
            .filter(|(before, _)| !before.ends_with('$'))
            .map(|(_, path)| path)
    });
    paths
        .map(|path| {
            let end = path.find(|c: char| !c.is_alphanumeric() && c != '_');
            &path[..end.unwrap_or(path.len())]
        })
        .collect()
}

#[test]
fn a_folder_names_only_those_before_it() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files(&source, "");
    let of_folders = files
        .iter()
        .filter(|(folder, _)| !["lib", "main"].contains(&&**folder));
    let inside = |path: &Path| path.strip_prefix(&source).expect("inside").to_owned();
    let mut used = vec![0; UP.len()];
    for (folder, path) in of_folders.filter(|(_, path)| !is_of_tests(&inside(path))) {
        let known = FOLDERS.iter().find(|(name, _)| name == folder);
        let (_, before) =
            known.unwrap_or_else(|| panic!("{} is in no folder of the list", path.display()));
        let text = fs::read_to_string(path).expect("readable");
        for named in named(&text) {
            if let Some(up) = UP.iter().position(|up| *up == (folder, named)) {
                used[up] += 1;
                continue;
            }
            let is_folder = FOLDERS.iter().any(|(name, _)| *name == named);
            assert!(
                named == folder || before.contains(&named) || !is_folder,
                "{} names `{named}`",
                path.display()
            );
        }
    }
    assert!(
        used.iter().all(|count| *count > 0),
        "an arrow is gone: take it out"
    );
}

#[test]
fn the_list_is_in_order() {
    for (k, (folder, before)) in FOLDERS.iter().enumerate() {
        for other in *before {
            let place = FOLDERS.iter().position(|(name, _)| name == other);
            assert!(
                place.is_some_and(|place| place < k),
                "{folder} names {other}"
            );
        }
    }
}
