//! `homogen convert`: writes a description as URDF or MJCF.

use std::io::Read;
use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::generate::write;
use super::options::{Asked, is_standard_input, warnings_of, written};
use super::{Answer, Outcome};
use homogen_codegen::convert::{OutputFormat, convert};
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::SOURCE;

/// Write a description as URDF or MJCF, as it was understood
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen convert robot.xml -o robot.urdf

Missing parts are warnings; what would move differently is an error, and nothing is written.")]
pub(super) struct Convert {
    /// A URDF, xacro, MJCF or SDF file, or a Denavit–Hartenberg table; `-` reads standard input
    file: PathBuf,
    #[command(flatten)]
    given: Asked<SOURCE>,
    /// The format to write [default: by the ending of the output, .xml for MJCF; otherwise URDF]
    #[arg(long, value_enum)]
    to: Option<Format>,
    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "OUT", default_value = "-")]
    output: PathBuf,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    Urdf,
    Mjcf,
}

impl Convert {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let request = self.given.and(Request::default());
        let description = written(&self.file, &request, input)?;
        let converted = convert(&description, self.format())?;
        let warnings: Vec<_> = (description.warnings.iter())
            .chain(&converted.warnings)
            .cloned()
            .collect();
        let remarks = warnings_of(&description.source, &warnings);
        let output = if is_standard_input(&self.output) {
            converted.text
        } else {
            write(&self.output, &converted.text)?;
            String::new()
        };
        Ok(Answer {
            output,
            remarks,
            code: 0,
        })
    }

    fn format(&self) -> OutputFormat {
        let is_xml = || {
            let ending = self.output.extension();
            ending.is_some_and(|ending| ending.eq_ignore_ascii_case("xml"))
        };
        match self.to {
            Some(Format::Mjcf) => OutputFormat::Mjcf,
            None if is_xml() => OutputFormat::Mjcf,
            Some(Format::Urdf) | None => OutputFormat::Urdf,
        }
    }
}

#[cfg(test)]
mod tests;
