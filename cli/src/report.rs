//! `homogen report`: speed against error, measured on this machine.
//!
//! In: a clone of the repository, somewhere above the current folder. Out: what the crate
//! `report/program` writes there. It only finds and starts that crate, which compiles what it
//! measures.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;

use super::options::mistake;
use super::{Answer, Said};
use homogen_codegen::error::{Errors, Place};

/// Measure speed against error on this machine, and write tables and plots
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Everything after `report` goes to the crate report/program of the repository:
  --output FOLDER   where to write [default: report in the repository]
  --long            measure six times as long
  --peers FOLDER    other implementations beside ours, as report/peer/setup.sh sets them up
Example:
  homogen report --output report-of-my-machine")]
pub(super) struct Report {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    arguments: Vec<OsString>,
}

impl Report {
    pub(super) fn run(&self) -> Said {
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

/// The manifest of the report's crate, in the nearest clone of the repository around a folder.
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
    fn outside_of_a_clone_it_says_what_to_do() {
        let errors = find(Path::new("/no/clone")).expect_err("there is none");
        let told = errors.to_string();
        assert!(
            told.contains("/no/clone") && told.contains("hint: "),
            "{told}"
        );
    }
}
