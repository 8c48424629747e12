//! `homogen inspect`: the code of a derive for one function, formatted, with its comment. The struct, traits and data
//! are left out.

use std::io::Read;

use clap::Args;

use super::options::{Robot, Scalar};
use super::{Answer, Outcome, functions};
use homogen_codegen::description::Name;
use homogen_codegen::expand::expand;
use homogen_codegen::function::Function;
use homogen_codegen::print::rust::{self, FormattedSource, Item, Library};
use homogen_codegen::request::setting::text::together;

/// Print the code of a derive, formatted, with its operation count
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen inspect arm.urdf --function mass_matrix")]
pub(super) struct Inspect {
    #[command(flatten)]
    robot: Robot,
    /// The function; several with + between them share their work
    #[arg(long, value_name = "NAME", value_parser = |text: &str| together(text).map(Together))]
    function: Together,
    /// The link of the pose or Jacobian, instead of the end effector
    #[arg(long, alias = "frames", value_name = "LINK")]
    frame: Option<String>,
    /// The type of numbers [default: any, as a type parameter]
    #[arg(long, value_enum)]
    scalar: Option<Scalar>,
}

/// Functions that share their work.
#[derive(Clone, Debug)]
struct Together(Vec<Function>);

impl Inspect {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let description = self.robot.description(input)?;
        let mut request = self.robot.request();
        request.functions.push(self.function.0.clone());
        request.frames.extend(self.frame.as_deref().map(Name::from));
        request.scalar = self.scalar.map(Into::into).unwrap_or_default();
        let mut module = expand(&description, &request)?;
        // A further frame comes after that of the end effector.
        let last = module.functions.len().saturating_sub(1);
        module.functions.drain(..last);
        let item = Item::named_after(&module.about.robot);
        let methods = rust::methods(&module, &item, &Library::default());
        Ok(Answer {
            output: FormattedSource::new("", &methods).to_string(),
            remarks: functions::warnings(&module.about),
            code: 0,
        })
    }
}
