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
use homogen_codegen::accuracy::{Accuracy, Bound, Perturbed};
use homogen_codegen::expand::expand;
use homogen_codegen::module::{GeneratedFunction, LeftOut, Module};
use homogen_codegen::schedule::OperationCount;
use homogen_codegen::wording::visible;

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

/// The numbers of an operation count in the order of the table; signs only if requested. A name of two words is a group
/// and a key.
fn columns(operation_count: &OperationCount, signs: bool) -> Vec<(&'static str, usize)> {
    let mut columns = vec![
        ("mul", operation_count.mul),
        ("add", operation_count.add),
        ("div", operation_count.div),
        ("sqrt", operation_count.sqrt),
        ("sin", operation_count.sin),
        ("cos", operation_count.cos),
        ("neg", operation_count.neg),
        ("fused", operation_count.fused),
        ("depth", operation_count.depth),
        ("literals", operation_count.literals),
        ("naive mul", operation_count.naive_mul),
        ("naive add", operation_count.naive_add),
    ];
    if signs {
        columns.push(("sign", operation_count.sign));
    }
    columns
}

/// True if any of the functions computes a sign, as those with Coulomb friction do.
pub(super) fn have_signs(functions: &[GeneratedFunction]) -> bool {
    functions
        .iter()
        .any(|generated| generated.operation_count.sign > 0)
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
        "warnings": json::warnings(&module.about.warnings),
    })
}

/// Operation count and error bounds of a function; signs only if requested.
pub(super) fn operation_count(generated: &GeneratedFunction, signs: bool) -> Value {
    let mut operation_count = json!({});
    for (name, number) in columns(&generated.operation_count, signs) {
        match name.split_once(' ') {
            Some((group, name)) => operation_count[group][name] = json!(number),
            None => operation_count[name] = json!(number),
        }
    }
    if let Some((_, cycles)) = generated.operation_count.cycles {
        operation_count["cycles"] = json!(cycles);
    }
    operation_count["errors"] = generated.accuracy.iter().map(error).collect();
    if let Some(found) = &generated.found {
        operation_count["found"] = json!({
            "of": "largest result",
            found.scalar.name(): found.relative,
            "random": found.random,
            "uphill": found.uphill,
        });
    }
    operation_count
}

/// Functions that the robot cannot have, with the reasons.
pub(super) fn left_out(module: &Module) -> Value {
    let left_out = module.about.left_out.iter();
    let left_out = left_out.map(
        |LeftOut {
             functions,
             reason,
             hint,
             is_fault,
         }| {
            json!({ "functions": functions, "reason": reason, "hint": hint, "fault": is_fault })
        },
    );
    left_out.collect()
}

/// An error bound: the maximum for each unit and type of number, and the bound of each joint, with the range where it
/// holds; or the reason why there is none.
fn error(accuracy: &Accuracy) -> Value {
    let (of, bounds) = match accuracy {
        Accuracy::Unknown(reason) => return json!({ "unknown": reason }),
        Accuracy::Within(bounds) => ("results", bounds),
        Accuracy::BesideDiagonal(bounds) => ("diagonal", bounds),
        Accuracy::Backward(Perturbed::Torques, bounds) => ("tau", bounds),
        Accuracy::Backward(Perturbed::MassMatrix, bounds) => ("M", bounds),
        Accuracy::Backward(Perturbed::UnitForces, bounds) => ("unit forces", bounds),
        Accuracy::Backward(Perturbed::TorqueDerivatives, bounds) => ("tau derivatives", bounds),
    };
    let by_unit = |of: fn(&Bound) -> Option<f64>| {
        let mut worst: Map<String, Value> = Map::new();
        for bound in &bounds.bounds {
            let found = of(bound);
            let before = worst.get(bound.unit).and_then(Value::as_f64);
            let most = found.map(|found| before.map_or(found, |before| before.max(found)));
            worst.insert(bound.unit.to_owned(), json!(most));
        }
        worst
    };
    let of_joint = |bound: &Bound| {
        let (joint, unit) = (&bound.joint, bound.unit);
        json!({ "joint": joint, "unit": unit, "f64": bound.double, "f32": bound.single })
    };
    json!({
        "of": of,
        "f64": by_unit(|bound| bound.double),
        "f32": by_unit(|bound| bound.single),
        "joints": bounds.bounds.iter().map(of_joint).collect::<Vec<_>>(),
        "range": bounds.range,
        "lacks": bounds.lacks,
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
