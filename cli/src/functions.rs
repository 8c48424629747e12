//! The functions that a command is asked about.
//!
//! In: names, alone or with `+` between them, and the links that they are of. Out: functions, all
//! that the robot has where none is named; and the builder that makes them. It never knows what a command
//! does with them.

use std::fmt::Write;
use std::io::Read;

use clap::Args;

use super::fields::Fields;
use super::options::{self, Robot};
use homogen_codegen::builder::Builder;
use homogen_codegen::error::Errors;
use homogen_codegen::function::Function;
use homogen_codegen::module::{LeftOut, Module};
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::wording::{known, list, visible};

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

/// The names of all functions, and where to begin.
pub(super) fn help() -> String {
    let mut text = "Functions:".to_owned();
    let mut column = usize::MAX;
    for name in Function::names() {
        // As wide as a terminal is at least.
        column = column.saturating_add(2 + name.len());
        if column > 80 {
            text.push('\n');
            column = 2 + name.len();
        }
        text.push_str("  ");
        text.push_str(name);
    }
    text + "\n\nExample:\n  homogen check arm.urdf"
}

impl Functions {
    /// What is asked of a robot; no functions where none is named, which means all that it has.
    pub(super) fn request(&self, robot: &Robot) -> Request {
        let functions = self.functions.iter().map(|item| item.0.clone());
        robot.request(&self.frames.frames, functions.collect())
    }

    /// The builder of what is asked of a robot in that type of number, under a name of its own where it has one; and
    /// the doubts about the robot.
    pub(super) fn builder(
        &self,
        robot: &Robot,
        fields: &Fields,
        (scalar, name): (Real, Option<&str>),
        input: &mut dyn Read,
    ) -> Result<(Builder, String), Errors> {
        let description = robot.written(input)?;
        let request = Request {
            scalar,
            ..self.request(robot)
        };
        let builder = Builder::from_description(description).request(request);
        let loops = robot.loops().iter();
        let builder = loops.fold(builder, Builder::closed);
        let builder = match name {
            Some(name) => builder.name(name),
            None => builder,
        };
        let builder = fields.of(builder).map_err(options::mistake)?;
        let chain = builder.understand()?;
        let remarks = options::warnings(&chain);
        Ok((builder, remarks))
    }

    /// The status of an answer about these functions: 0, or [`FAULT`].
    pub(super) fn code(module: &Module) -> u8 {
        let mut left_out = module.about.left_out.iter();
        if left_out.any(|left_out| left_out.is_fault) {
            FAULT
        } else {
            0
        }
    }

    /// What a person should know about the answer: what the robot cannot have.
    pub(super) fn remarks(module: &Module) -> String {
        let mut text = String::new();
        for LeftOut {
            functions,
            reason,
            hint,
            ..
        } in &module.about.left_out
        {
            let functions = list(functions.iter().map(String::as_str));
            // Writing to a string cannot fail.
            let _ = writeln!(text, "note: left out: {functions}: {reason}");
            if let Some(hint) = hint {
                let _ = writeln!(text, "  hint: {}", visible(hint));
            }
        }
        text
    }
}

/// The status of a command that left out a function by a fault of homogen.
pub(super) const FAULT: u8 = 3;

/// The function of that name.
pub(super) fn function(text: &str) -> Result<Function, String> {
    Function::from_name(text).ok_or_else(|| {
        let hint = known(text, "functions", &Function::names());
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
