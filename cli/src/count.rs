//! `homogen count`: operation counts of functions.
//!
//! Prints a table of the operation counts in the comments of the generated functions, beside those of dense 4×4
//! products, with the largest error found where the algorithm was chosen by it; functions that the robot cannot have;
//! and every warning. As JSON it also has error bounds.

use std::fmt::Write;
use std::io::Read;

use clap::Args;
use serde_json::{Map, Value, json};

use super::functions::{self, Functions};
use super::options::{Format, Robot};
use super::{Answer, Outcome, json};
use homogen_codegen::expand::expand;
use homogen_codegen::module::{GeneratedFunction, Module};
use homogen_codegen::schedule::OperationCount;
use homogen_codegen::wording::visible;
use homogen_page::count::{columns, have_signs, left_out, operation_count};
use homogen_page::diagnostics::warnings;

/// Count the operations, depth and literals of each function
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen count arm.urdf --functions inverse_dynamics,mass_matrix+bias --format json

Exit status: 0; 1 for an error in the input; 2 for one in the arguments; 3 if all functions were requested and one was
left out because of a fault of homogen, which standard error reports.")]
pub(super) struct Count {
    #[command(flatten)]
    robot: Robot,
    #[command(flatten)]
    functions: Functions,
    /// Format of the answer
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

impl Count {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let description = self.robot.description(input)?;
        let request = self.functions.and(self.robot.request());
        let module = expand(&description, &request)?;
        Ok(match self.format {
            Format::Text => Answer {
                output: table(&module.functions),
                remarks: functions::remarks(&module),
                code: functions::status(&module),
            },
            Format::Json => Answer {
                output: json::answer(in_json(&module)),
                code: functions::status(&module),
                ..Answer::default()
            },
        })
    }
}

fn in_json(module: &Module) -> Value {
    let signs = have_signs(&module.functions);
    let counts = (module.functions.iter())
        .map(|generated| (generated.name(), operation_count(generated, signs)));
    let counts: Map<String, Value> = counts.collect();
    json!({
        "robot": module.about.robot,
        "functions": counts,
        "left_out": left_out(module),
        "warnings": warnings(&module.about.warnings),
    })
}

/// Head of the column of errors that were found, relative to the largest result.
const FOUND: &str = "error found";

/// A row for each function; with the largest error found, if the algorithm of any was chosen by it.
fn table(functions: &[GeneratedFunction]) -> String {
    let names = functions.iter().map(GeneratedFunction::name);
    let names: Vec<String> = names.map(|name| visible(&name).into_owned()).collect();
    let width = names.iter().map(|name| name.chars().count()).max();
    let width = width.unwrap_or(0);
    let mut text = format!("{:width$}", "");
    let signs = have_signs(functions);
    for (head, _) in columns(&OperationCount::default(), signs) {
        text.push_str("  ");
        text.push_str(head);
    }
    let any_found = functions.iter().any(|generated| generated.found.is_some());
    if any_found {
        text.push_str("  ");
        text.push_str(FOUND);
    }
    for (name, generated) in names.iter().zip(functions) {
        // Writing to a string cannot fail.
        let _ = write!(text, "\n{name:width$}");
        for (head, number) in columns(&generated.operation_count, signs) {
            let column = head.len();
            let _ = write!(text, "  {number:>column$}");
        }
        if let Some(found) = &generated.found {
            let column = FOUND.len();
            let _ = write!(text, "  {:>column$.1e}", found.relative);
        }
    }
    text.push('\n');
    text
}
