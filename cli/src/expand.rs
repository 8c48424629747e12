//! `homogen expand`: the URDF that a xacro file expands to.

use std::io::Read;
use std::path::{Path, PathBuf};

use clap::Args;

use super::options::{Asked, STANDARD_INPUT, is_standard_input, mistake, read};
use super::{Answer, Outcome, options};
use homogen_codegen::description::{Given, expand_file, xacro};
use homogen_codegen::error::Errors;
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::SOURCE;

/// Print the URDF that a xacro file expands to
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen expand robot.urdf.xacro --arguments type=arm > robot.urdf")]
pub(super) struct Expand {
    /// A xacro file; `-` reads standard input
    file: PathBuf,
    #[command(flatten)]
    given: Asked<SOURCE>,
}

impl Expand {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let given = Given::of(&self.given.and(Request::default()), Path::new(""));
        let mut errors = Errors::new();
        let urdf = if is_standard_input(&self.file) {
            let text = String::from_utf8(read(input)?);
            let text = text.map_err(|_| mistake("standard input is not UTF-8"))?;
            xacro::expanded(&text, STANDARD_INPUT, None, &given, &mut errors)
        } else {
            expand_file(&self.file, &given, &mut errors)
        };
        let Some(output) = urdf else {
            return Err(errors);
        };
        Ok(Answer {
            output,
            remarks: options::remarks(&errors, errors.warnings()),
            code: 0,
        })
    }
}
