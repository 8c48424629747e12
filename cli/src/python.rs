//! `homogen python`: a package for Python that `pip` builds, as the builder writes it. A folder is written completely
//! or not at all, and other folders are not overwritten.

use std::io::Read;
use std::path::PathBuf;

use clap::Args;

use super::functions::{self, Generated};
use super::options::{Scalar, is_standard_input, mistake};
use super::{Answer, Outcome};
use homogen_codegen::builder::{module_of, write_folder};
use homogen_codegen::request::Request;

/// Write a package for Python: the functions of a robot for NumPy arrays, of one state or of many
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen python arm.urdf -o arm_py
  pip install ./arm_py
  python -c 'import arm_py; help(arm_py)'")]
pub(super) struct Python {
    #[command(flatten)]
    generated: Generated,
    /// The type of numbers
    #[arg(long, value_enum, default_value = "f64")]
    scalar: Scalar,
    /// The folder to write; the module has its name
    #[arg(long, short, value_name = "FOLDER")]
    output: PathBuf,
}

impl Python {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        if is_standard_input(&self.output) {
            return Err(mistake(
                "a package consists of several files: name a folder",
            ));
        }
        let module = module_of(&self.output)?;
        let request = Request {
            scalar: self.scalar.into(),
            ..Request::default()
        };
        let builder = self.generated.builder(request, input)?;
        let generated = builder.python_module()?;
        let package = builder.python(&generated, &module);
        write_folder(&self.output, &package)?;
        Ok(Answer {
            output: format!("from {} import {}\n", package.module, package.class),
            remarks: functions::remarks(&generated),
            code: functions::status(&generated),
        })
    }
}
