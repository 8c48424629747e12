//! Test of the dependences between the folders of this crate: each uses only those before it in a list.
//!
//! In: the sources without their tests. Out: a failure if `crate::` in code is followed by a folder that may not be
//! named, or if a method is called that only such a folder defines. Methods whose names several folders define are not
//! seen.

use std::collections::{BTreeMap, BTreeSet};
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
    (
        "range",
        &["list", "space", "expression", "request", "chain"],
    ),
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
            "description",
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
            "request",
            "description",
            "chain",
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

/// Methods of a folder here that are also methods of a library, or are named in messages.
const OF_LIBRARIES: [&str; 19] = [
    "c",
    "chain",
    "components",
    "expect",
    "extend",
    "get_mut",
    "import",
    "insert",
    "into_iter",
    "lock",
    "package",
    "parse",
    "peek",
    "reduce",
    "remove",
    "shape",
    "span",
    "suffix",
    "values",
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

/// The lines of a file without comments and without its module of tests.
fn code(text: &str) -> String {
    let code = text.split("\nmod tests {").next().unwrap_or_default();
    let lines = code.lines().filter(|line| !line.trim().starts_with("//"));
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// The identifier at the start of a text.
fn identifier(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_');
    &text[..end.unwrap_or(text.len())]
}

/// The folders that code names.
fn named(code: &str) -> impl Iterator<Item = &str> {
    let paths = code.match_indices("crate::");
    // A path in a macro, or in printed code, belongs to another crate.
    let own = paths.filter(|(at, _)| !code[..*at].ends_with('$'));
    own.map(|(at, path)| identifier(&code[at + path.len()..]))
}

/// The methods that code defines.
fn defined(code: &str) -> impl Iterator<Item = &str> {
    code.match_indices("fn ").filter_map(|(at, word)| {
        let rest = &code[at + word.len()..];
        let (_, arguments) = rest.split_once('(')?;
        let first = arguments.trim_start().trim_start_matches('&');
        let first = if first.starts_with('\'') {
            first.split_once(' ')?.1
        } else {
            first
        };
        let receiver = identifier(first.trim_start_matches("mut "));
        (receiver == "self").then(|| identifier(rest))
    })
}

/// The methods that code calls.
fn called(code: &str) -> impl Iterator<Item = &str> {
    let dots = code.match_indices('.');
    let single = dots.filter(|(at, _)| !code[..*at].ends_with('.'));
    single.filter_map(|(at, dot)| {
        let rest = &code[at + dot.len()..];
        let name = identifier(rest);
        rest[name.len()..].starts_with(['(', ':']).then_some(name)
    })
}

/// The code of each file that is not of tests, with its folder.
fn sources() -> Vec<(String, PathBuf, String)> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let inside = |path: &Path| path.strip_prefix(&source).expect("inside").to_owned();
    files(&source, "")
        .into_iter()
        .filter(|(folder, _)| !["lib", "main"].contains(&&**folder))
        .filter(|(_, path)| !is_of_tests(&inside(path)))
        .map(|(folder, path)| {
            let text = fs::read_to_string(&path).expect("readable");
            (folder, path, code(&text))
        })
        .collect()
}

/// True if the files of a folder may use another.
fn may_use(folder: &str, other: &str) -> bool {
    let known = FOLDERS.iter().find(|(name, _)| *name == folder);
    let (_, before) = known.unwrap_or_else(|| panic!("`{folder}` is not in the list of folders"));
    let is_folder = FOLDERS.iter().any(|(name, _)| *name == other);
    folder == other || before.contains(&other) || !is_folder
}

#[test]
fn a_folder_names_only_those_before_it() {
    let mut used = vec![0; UP.len()];
    for (folder, path, code) in &sources() {
        for named in named(code) {
            if let Some(up) = UP.iter().position(|up| *up == (folder, named)) {
                used[up] += 1;
                continue;
            }
            assert!(may_use(folder, named), "{} names `{named}`", path.display());
        }
    }
    assert!(
        used.iter().all(|count| *count > 0),
        "an arrow is gone: take it out"
    );
}

#[test]
fn a_folder_calls_only_methods_of_those_before_it() {
    let sources = sources();
    let mut owners: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (folder, _, code) in &sources {
        for method in defined(code) {
            owners.entry(method).or_default().insert(folder);
        }
    }
    for (folder, path, code) in &sources {
        for method in called(code).filter(|method| !OF_LIBRARIES.contains(method)) {
            let owners = owners.get(method).into_iter().flatten();
            let [owner] = owners.collect::<Vec<_>>()[..] else {
                continue;
            };
            assert!(
                may_use(folder, owner) || UP.contains(&(folder, owner)),
                "{} calls `{method}`, which only `{owner}` has",
                path.display()
            );
        }
    }
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
