//! The functions that a command is asked about.
//!
//! In: names, alone or with `+` between them, and the links that they are of. Out: functions; all
//! that the robot has where none is named. It never knows what a command does with them.

use clap::Args;

use super::options::{self, Robot};
use crate::chain;
use crate::description::Description;
use crate::error::Errors;
use crate::function::Function;
use crate::request::Request;
use crate::wording::known;

/// Functions, and further frames that they are of.
#[derive(Args, Clone, Debug)]
pub(super) struct Functions {
    /// The functions; several with + between them share their work and count as one
    /// [default: all]
    #[arg(long, alias = "function", value_name = "NAME,…", value_delimiter = ',')]
    #[arg(value_parser = together)]
    functions: Vec<Together>,
    #[command(flatten)]
    frames: Frames,
}

/// Further frames.
#[derive(Args, Clone, Debug)]
pub(super) struct Frames {
    /// Further links whose poses and Jacobians are wanted
    #[arg(long, alias = "frame", value_name = "LINK,…", value_delimiter = ',')]
    pub(super) frames: Vec<String>,
}

/// Functions that share their work.
#[derive(Clone, Debug)]
pub(super) struct Together(pub(super) Vec<Function>);

impl Functions {
    /// What is asked of a robot, and what a person should know about it.
    pub(super) fn request(
        &self,
        robot: &Robot,
        description: &Description,
    ) -> Result<(Request, String), Errors> {
        let frames = &self.frames.frames;
        let chain = chain::build(description, &robot.request(frames, &[]))?;
        let mut remarks = options::warnings(description, &chain.report.warnings);
        let mut functions = self.functions.clone();
        if functions.is_empty() {
            functions = Function::ALL
                .map(|function| Together(vec![function]))
                .into();
            if chain.frames.is_empty() {
                functions.retain(|item| item.0.iter().all(|function| !function.of_a_frame()));
                remarks.push_str(SEVERAL_ENDS);
            }
        }
        Ok((robot.request(frames, &functions), remarks))
    }
}

const SEVERAL_ENDS: &str = "\
note: the robot has more than one end: functions of a frame are left out
  hint: name one of the links as --tip
";

/// The function of that name.
pub(super) fn function(text: &str) -> Result<Function, String> {
    Function::from_name(text).ok_or_else(|| {
        let hint = known(text, "functions", &Function::ALL.map(Function::name));
        format!("there is no such function\n  hint: {hint}")
    })
}

/// `mass_matrix`, or `mass_matrix+bias`.
pub(super) fn together(text: &str) -> Result<Together, String> {
    let mut functions = Vec::new();
    for name in text.split('+') {
        let function = function(name)?;
        if functions.contains(&function) {
            return Err(format!("{name} is asked for twice"));
        }
        functions.push(function);
    }
    Ok(Together(functions))
}
