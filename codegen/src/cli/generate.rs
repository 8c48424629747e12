//! `homogen generate`: a file of Rust that needs `core` and nothing else.
//!
//! In: a description and names of functions. Out: what the builder of a build script writes, with
//! the same tokens. It never writes a file before everything is known to be right.

use std::io::Read;
use std::path::{Path, PathBuf};

use clap::Args;

use super::functions::Functions;
use super::options::{Robot, Scalar, is_standard_input, mistake};
use super::{Answer, Said, options};
use crate::builder::Builder;
use crate::error::Errors;
use crate::expand;

/// Write the functions of a robot as a file of Rust that needs core and nothing else
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen generate arm.urdf --scalar f32 --functions inverse_dynamics,gravity -o arm.rs")]
pub(super) struct Generate {
    #[command(flatten)]
    robot: Robot,
    #[command(flatten)]
    functions: Functions,
    /// The type of number
    #[arg(long, value_enum, default_value = "f64")]
    scalar: Scalar,
    /// The path of a function from an angle to its sine and cosine, such as ::libm::sincosf
    /// [default: the file brings its own]
    #[arg(long, value_name = "PATH")]
    sin_cos: Option<String>,
    /// Functions for C as well, whose names begin with this
    #[arg(long, value_name = "PREFIX")]
    extern_c: Option<String>,
    /// The file to write the header of the functions for C to
    #[arg(long, value_name = "OUT", requires = "extern_c")]
    c_header: Option<PathBuf>,
    /// The name of the struct [default: the robot's]
    #[arg(long)]
    name: Option<String>,
    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "OUT", default_value = "-")]
    output: PathBuf,
}

impl Generate {
    pub(super) fn run(&self, input: &mut dyn Read) -> Said {
        let description = self.robot.description(input)?;
        let mut request = self.functions.request(&self.robot);
        request.scalar = self.scalar.into();
        let chain = expand::understand(&description, &request)?;
        let mut remarks = options::warnings(&description, &chain.report.warnings);
        let mut builder = Builder::from_description(description).request(request);
        if let Some(name) = &self.name {
            builder = builder.name(name);
        }
        if let Some(path) = &self.sin_cos {
            builder = builder.sin_cos(path);
        }
        if let Some(prefix) = &self.extern_c {
            builder = builder.extern_c(prefix);
        }
        let listing = builder.listing()?;
        remarks.push_str(&Functions::remarks(&listing));
        let mut output = builder.source(&listing).to_string();
        if let Some(path) = &self.c_header {
            write(path, &builder.c_header(&listing))?;
        }
        if !is_standard_input(&self.output) {
            write(&self.output, &output)?;
            output.clear();
        }
        Ok(Answer {
            output,
            remarks,
            code: 0,
        })
    }
}

fn write(path: &Path, text: &str) -> Result<(), Errors> {
    let refuse = |reason| mistake(format!("cannot write {}: {reason}", path.display()));
    std::fs::write(path, text).map_err(refuse)
}
