//! Finds the clone of the repository that commands need which compile parts of it.

use std::path::Path;

use homogen_codegen::error::{Errors, Place};

/// The nearest clone at or above a folder; `reason` states why the command needs one.
pub(super) fn find<'f>(folder: &'f Path, reason: &str) -> Result<&'f Path, Errors> {
    let mut clones = folder.ancestors().filter(|folder| {
        let holds = |path| folder.join(path).is_file();
        holds("cli/src/clone.rs") && holds("report/program/Cargo.toml") && holds("site/Cargo.toml")
    });
    if let Some(clone) = clones.next() {
        return Ok(clone);
    }
    let mut errors = Errors::new();
    errors.push_with_hint(
        Place::Unknown,
        format!("no clone of homogen at or above {}", folder.display()),
        format!("{reason}: clone the repository and run it there"),
    );
    Err(errors)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::find;

    #[test]
    fn a_clone_is_found_from_inside() {
        let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let found = find(&here, "").expect("this is a clone");
        assert!(found.join("site/Cargo.toml").is_file());
    }

    #[test]
    fn outside_of_a_clone_there_is_a_hint() {
        let errors =
            find(Path::new("/no/clone"), "the site compiles its module").expect_err("none");
        let message = errors.to_string();
        assert!(
            message.contains("/no/clone") && message.contains("hint: the site compiles"),
            "{message}"
        );
    }
}
