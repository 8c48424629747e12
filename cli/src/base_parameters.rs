//! `homogen base-parameters`: base parameters of a robot.
//!
//! Prints the base parameters in the order of the columns of the base regressor: each as a linear combination of
//! inertial parameters, with its described value.

use std::fmt::Write;
use std::io::Read;

use clap::Args;
use serde_json::{Value, json};

use super::options::{Format, Robot};
use super::{Answer, Outcome, json, options};
use homogen_codegen::chain::Chain;
use homogen_codegen::chain::base_parameters::{BaseParameter, BaseParameters as Found};
use homogen_codegen::expand;
use homogen_codegen::list::List;
use homogen_codegen::space::{Entry, Kind, ParameterId};
use homogen_codegen::wording::visible;
use homogen_page::diagnostics::warnings;

/// List the base parameters: the linear combinations of inertial parameters that torques determine, with their values
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen base-parameters arm.urdf --format json")]
pub(super) struct BaseParameters {
    #[command(flatten)]
    robot: Robot,
    /// Format of the answer
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

impl BaseParameters {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let description = self.robot.description(input)?;
        let request = self.robot.request();
        let chain = expand::understand(&description, &request)?;
        homogen_codegen::plan::check_size(&chain)?;
        let chain = expand::identified(chain)?;
        let base = chain.base_parameters.clone().unwrap_or_default();
        Ok(match self.format {
            Format::Text => Answer {
                output: in_text(&description.name.text, &chain, &base),
                remarks: options::warnings(&chain),
                code: 0,
            },
            Format::Json => Answer {
                output: json::answer(in_json(&description.name.text, &chain, &base)),
                ..Answer::default()
            },
        })
    }
}

const fn unit(entry: &Entry) -> &'static str {
    match entry.kind {
        Kind::Moment(0)
        | Kind::Actuator {
            order: 2,
            translates: true,
        } => "kg",
        Kind::Moment(1) => "kg m",
        Kind::Actuator {
            order: 1,
            translates: true,
        } => "N s/m",
        Kind::Actuator {
            order: 0,
            translates: true,
        } => "N",
        Kind::Actuator { order: 1, .. } => "N m s",
        Kind::Actuator { order: 0, .. } => "N m",
        _ => "kg m²",
    }
}

fn in_json(robot: &str, chain: &Chain, base: &Found) -> Value {
    let parameters = &chain.spaces().parameters;
    let groups = base.groups.iter().map(|group| {
        let members = group.members.iter().map(|&(parameter, factor)| {
            json!({ "parameter": parameters[parameter].name, "factor": factor })
        });
        let leading = &parameters[group.leading()];
        json!({
            "leading": leading.name,
            "unit": unit(leading),
            "value": group.value,
            "members": members.collect::<Value>(),
        })
    });
    json!({
        "robot": robot,
        "parameters": parameters.iter().map(|entry| entry.name.as_str()).collect::<Value>(),
        "base_parameters": groups.collect::<Value>(),
        "warnings": warnings(&chain.report.warnings),
    })
}

fn in_text(robot: &str, chain: &Chain, base: &Found) -> String {
    let parameters = &chain.spaces().parameters;
    let groups = &base.groups;
    let mut text = String::new();
    let (some, all) = (groups.len(), parameters.len());
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "robot {}: {some} base parameters of {all} inertial parameters",
        visible(robot)
    );
    for group in groups {
        let (value, unit) = (group.value, unit(&parameters[group.leading()]));
        let _ = writeln!(
            text,
            "  {value} {unit} = {}",
            visible(&sum(group, parameters))
        );
    }
    text
}

/// A base parameter as a sum.
fn sum(group: &BaseParameter, parameters: &List<ParameterId, Entry>) -> String {
    let mut sum = String::new();
    for (k, &(parameter, factor)) in group.members.iter().enumerate() {
        let sign = match (k, factor < 0.0) {
            (0, true) => "−",
            (0, false) => "",
            (_, true) => " − ",
            (_, false) => " + ",
        };
        sum.push_str(sign);
        let size = factor.abs();
        if (size - 1.0).abs() > 0.0 {
            // Writing to a string cannot fail.
            let _ = write!(sum, "{size} ");
        }
        sum.push_str(&parameters[parameter].name);
    }
    sum
}
