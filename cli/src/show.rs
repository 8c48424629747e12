//! `homogen show`: a robot and its functions as a page for a browser.
//!
//! One file of HTML without network requests: the robot as a skeleton to rotate, with joints to move, a summary of the
//! description, and every function with its operation count, error bound and code. Texts of the robot are data in it
//! and cannot run.

#[cfg(test)]
mod tests;

use std::io::Read;
use std::path::PathBuf;

use clap::Args;
use serde_json::Value;

use super::functions::{self, Functions};
use super::generate::write;
use super::options::{Robot, Scalar, is_standard_input};
use super::{Answer, Outcome, json};
use homogen_codegen::expand;
use homogen_codegen::template::filled;

/// The page, with marks for the following parts.
const PAGE: &str = include_str!("show/page.html");

/// The elements of a robot's view.
pub(super) const ROBOT: &str = include_str!("show/robot.html");

/// Its style sheet.
pub(super) const STYLE: &str = include_str!("show/page.css");

/// A script with the parts of a robot's view, in a scope of its own, and further files after them.
macro_rules! view {
    ($($after:expr),*) => {
        concat!(
            "\"use strict\";\n{\n",
            include_str!("show/elements.js"),
            include_str!("show/kinematics.js"),
            include_str!("show/camera.js"),
            include_str!("show/singular.js"),
            include_str!("show/scene.js"),
            include_str!("show/names.js"),
            include_str!("show/code.js"),
            include_str!("show/explain.js"),
            include_str!("show/loops.js"),
            include_str!("show/joints.js"),
            include_str!("show/tables.js"),
            include_str!("show/functions.js"),
            include_str!("show/robot.js"),
            $($after,)*
            "}\n"
        )
    };
}
pub(super) use view;

/// Its script.
const SCRIPT: &str = view!(include_str!("show/main.js"));

/// SHA-256 of the script and of the style sheet, in base 64: the page forbids all others. A test compares them, and
/// prints the correct ones.
const SCRIPT_HASH: &str = "GSCMjr2U+oPS1LOyfhdy+fbqHd2Newkx+jE77z1fjwU=";
const STYLE_HASH: &str = "EZ41wpWxxdiq7VbW1QjP3bio5MhdE8Ppc0rj96n9JgQ=";

/// Write a page for a browser: the robot as a skeleton to move, the description, and every function with its operation
/// count, error bound and code
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen show arm.urdf -o arm.html

The page is one file and needs no network. Operations are counted; no time is measured, and with --processor the
cycles are those of its model.")]
pub(super) struct Show {
    #[command(flatten)]
    robot: Robot,
    #[command(flatten)]
    functions: Functions,
    /// The type of numbers in the code [default: any, as a type parameter]
    #[arg(long, value_enum)]
    scalar: Option<Scalar>,
    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "OUT", default_value = "-")]
    output: PathBuf,
}

impl Show {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let description = self.robot.description(input)?;
        let mut request = self.functions.and(self.robot.request());
        request.scalar = self.scalar.map(Into::into).unwrap_or_default();
        // The page shows the origin of each name, which an array between sections would hide.
        request.section = Some(usize::MAX);
        let chain = expand::identified_if_asked(expand::understand(&description, &request)?);
        let module = expand::of_chain(&chain)?;
        let remarks = functions::remarks(&module);
        let data = homogen_page::data(&chain, &module)?;
        let output = page(&data);
        if is_standard_input(&self.output) {
            return Ok(Answer {
                output,
                remarks,
                code: functions::status(&module),
            });
        }
        write(&self.output, &output)?;
        Ok(Answer {
            remarks,
            code: functions::status(&module),
            ..Answer::default()
        })
    }
}

/// The page with its data.
fn page(data: &Value) -> String {
    let policy = format!(
        "default-src 'none'; script-src 'sha256-{SCRIPT_HASH}'; style-src 'sha256-{STYLE_HASH}'; \
         base-uri 'none'; form-action 'none'"
    );
    let words = [
        ("@POLICY@", &*policy),
        ("@STYLE@", STYLE),
        ("@SCRIPT@", SCRIPT),
        ("@ROBOT@", ROBOT),
        ("@DATA@", &json::in_markup(data)),
    ];
    filled(PAGE, &words)
}
