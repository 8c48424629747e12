//! `homogen report`: speed and error, measured on this machine.
//!
//! Finds and runs the crate `report/program` of a clone of the repository, at or above the current folder.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;

use super::options::mistake;
use super::{Answer, Outcome};
use homogen_codegen::error::{Errors, Place};

/// Measure speed and error on this machine, and write tables and plots
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Everything after `report` goes to the crate report/program of the repository:
  --output FOLDER   the folder to write to [default: report in the repository]
  --long            measure six times as long
  --peers FOLDER    other implementations to compare with, as set up by report/peer/setup.sh
Example:
  homogen report --output report-of-my-machine")]
pub(super) struct Report {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    arguments: Vec<OsString>,
}

impl Report {
    pub(super) fn run(&self) -> Outcome {
        let here = env::current_dir().map_err(|reason| mistake(reason.to_string()))?;
        let manifest = find(&here)?;
        let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let status = Command::new(cargo)
            .args(["run", "--quiet", "--manifest-path"])
            .arg(manifest)
            .arg("--")
            .args(&self.arguments)
            .status()
            .map_err(|reason| mistake(format!("cannot run cargo: {reason}")))?;
        Ok(Answer {
            code: u8::from(!status.success()),
            ..Answer::default()
        })
    }
}

/// The manifest of the report's crate, in the nearest clone at or above a folder.
fn find(folder: &Path) -> Result<PathBuf, Errors> {
    let mut clones = folder.ancestors().filter(|folder| {
        let holds = |path| folder.join(path).is_file();
        holds("cli/src/report.rs") && holds("report/program/Cargo.toml")
    });
    if let Some(clone) = clones.next() {
        return Ok(clone.join("report/program/Cargo.toml"));
    }
    let mut errors = Errors::new();
    errors.push_with_hint(
        Place::Unknown,
        format!("no clone of homogen at or above {}", folder.display()),
        "the report compiles what it measures: clone the repository and run it there",
    );
    Err(errors)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::find;

    #[test]
    fn a_clone_is_found_from_inside() {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let found = find(&here.join("src")).expect("this is a clone");
        assert!(found.ends_with("report/program/Cargo.toml"));
        assert!(found.is_file());
    }

    #[test]
    fn outside_of_a_clone_there_is_a_hint() {
        let errors = find(Path::new("/no/clone")).expect_err("there is none");
        let message = errors.to_string();
        assert!(
            message.contains("/no/clone") && message.contains("hint: "),
            "{message}"
        );
    }
}
