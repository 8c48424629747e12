//! The modules of this crate: each uses only those above it in the table of the front page.
//!
//! In: the sources. The test fails if `crate::` is followed by a module that is not allowed. It does not check paths
//! with `super`.

use std::fs;
use std::path::{Path, PathBuf};

/// Each module with those that it may use. The macros `every_function` and `every_function_of_spheres` belong to
/// `robot`, although exported macros are at the root.
const MODULES: [(&str, &[&str]); 10] = [
    ("scalar", &[]),
    ("error", &["scalar"]),
    ("matrix", &["scalar", "error"]),
    ("robot", &["scalar", "error", "matrix"]),
    ("paper", &["scalar", "error", "matrix", "robot"]),
    ("reference", &["matrix", "robot", "every_function"]),
    ("ik", &["scalar", "error", "matrix", "robot"]),
    ("identify", &["scalar", "paper"]),
    ("step", &["scalar", "matrix", "robot"]),
    (
        "batch",
        &[
            "scalar",
            "matrix",
            "robot",
            "every_function",
            "every_function_of_spheres",
        ],
    ),
];

/// The files below a path, each with its module.
fn files(path: &Path, module: &str) -> Vec<(String, PathBuf)> {
    let entries = fs::read_dir(path).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("readable").path());
    paths
        .flat_map(|path| {
            let stem = path.file_stem().and_then(|stem| stem.to_str());
            let stem = stem.expect("a name").to_owned();
            let module = if module.is_empty() { &stem } else { module };
            if path.is_dir() {
                files(&path, module)
            } else {
                vec![(module.to_owned(), path)]
            }
        })
        .filter(|(_, path)| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}

#[test]
fn a_module_uses_only_those_above_it() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files(&source, "");
    assert!(files.len() > 30, "only {} files", files.len());
    for (module, path) in files.iter().filter(|(module, _)| module != "lib") {
        let known = MODULES.iter().find(|(name, _)| name == module);
        let (_, above) = known.unwrap_or_else(|| panic!("{} is in no module", path.display()));
        let text = fs::read_to_string(path).expect("readable");
        // Paths by `$crate::` in a macro belong to the caller of the macro.
        let text = text.replace("$crate::", "");
        let code = text.lines().filter(|line| !line.trim().starts_with("//"));
        for named in code.flat_map(|line| line.split("crate::").skip(1)) {
            let end = named.find(|c: char| !c.is_alphanumeric() && c != '_');
            let named = &named[..end.unwrap_or(named.len())];
            assert!(
                named == module || above.contains(&named),
                "{} uses `{named}`",
                path.display()
            );
        }
    }
}
