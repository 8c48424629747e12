//! The functions that a command is about.
//!
//! Names, alone or with `+` between them, and links with frames; without names all functions that the robot has. Yields
//! the builder and the generated module.

use std::fmt::Write;
use std::io::Read;

use clap::Args;

use super::fields::Fields;
use super::options::{self, Asked, Robot};
use homogen_codegen::builder::Builder;
use homogen_codegen::error::Errors;
use homogen_codegen::function::Function;
use homogen_codegen::module::{About, LeftOut, Module};
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::{FIELDS, FRAMES, FUNCTIONS};
use homogen_codegen::wording::{list, visible};

/// Functions, and links with further frames.
pub(super) type Functions = Asked<{ FUNCTIONS | FRAMES }>;

/// A generated module with its robot.
#[derive(Args, Clone, Debug)]
pub(super) struct Generated {
    #[command(flatten)]
    robot: Robot,
    #[command(flatten)]
    asked: Asked<{ FUNCTIONS | FRAMES | FIELDS }>,
    #[command(flatten)]
    fields: Fields,
    /// The name of the struct, of the class, or of the robot in C [default: the robot's name]
    #[arg(long)]
    name: Option<String>,
}

/// The names of all functions, with an example.
pub(super) fn help() -> String {
    let mut text = "Functions:".to_owned();
    let mut column = usize::MAX;
    for name in Function::names() {
        // Fits into a terminal of 80 columns.
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

impl Generated {
    /// The builder for the requested functions.
    pub(super) fn builder(
        &self,
        request: Request,
        input: &mut dyn Read,
    ) -> Result<Builder, Errors> {
        let request = self.asked.and(self.robot.asked.and(request));
        let builder = Builder::from_description(self.robot.written(input)?).request(request);
        let builder = match &self.name {
            Some(name) => builder.name(name),
            None => builder,
        };
        self.fields.of(builder).map_err(options::mistake)
    }
}

/// The warnings about generated code.
pub(super) fn warnings(about: &About) -> String {
    options::warnings_of(&about.source, &about.warnings)
}

/// The exit status: 0, or [`FAULT`].
pub(super) fn status(module: &Module) -> u8 {
    let mut left_out = module.about.left_out.iter();
    if left_out.any(|left_out| left_out.is_fault) {
        FAULT
    } else {
        0
    }
}

/// Messages about the answer: warnings, and functions that the robot cannot have.
pub(super) fn remarks(module: &Module) -> String {
    let about = &module.about;
    let mut text = warnings(about);
    for LeftOut {
        functions,
        reason,
        hint,
        ..
    } in &about.left_out
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

/// The exit status of a command that left out a function because of a fault of homogen.
pub(super) const FAULT: u8 = 3;
