//! `homogen report`: speed and error, measured on this machine.
//!
//! Finds and runs the crate `report/program` of a clone of the repository, at or above the current folder.

use std::env;
use std::ffi::OsString;
use std::process::Command;

use clap::Args;

use super::options::mistake;
use super::{Answer, Outcome, clone};

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
        let clone = clone::find(&here, "the report compiles what it measures")?;
        let manifest = clone.join("report/program/Cargo.toml");
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
