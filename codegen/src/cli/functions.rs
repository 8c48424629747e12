//! The functions that a command is asked about.
//!
//! In: names, alone or with `+` between them, and the links that they are of. Out: functions; all
//! that the robot has where none is named. It never knows what a command does with them.

use clap::Args;

use super::options::Robot;
use crate::emit::Listing;
use crate::function::Function;
use crate::request::Request;
use crate::wording::{known, list};

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
    /// What is asked of a robot; no functions where none is named, which means all that it has.
    pub(super) fn request(&self, robot: &Robot) -> Request {
        robot.request(&self.frames.frames, &self.functions)
    }

    /// What a person should know about the answer.
    pub(super) fn remarks(&self, listing: &Listing) -> String {
        if !self.functions.is_empty() {
            return String::new();
        }
        let all = Function::ALL.into_iter();
        let missing = all.filter(|function| {
            let mut listed = listing.functions.iter();
            listed.all(|listed| listed.functions != [*function])
        });
        let missing: Vec<&str> = missing.map(Function::name).collect();
        if missing.is_empty() {
            return String::new();
        }
        format!(
            "note: left out: {}\n  hint: ask for one with --functions to hear why\n",
            list(missing)
        )
    }
}

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
