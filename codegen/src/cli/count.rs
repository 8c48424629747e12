//! `homogen count`: what each function costs.
//!
//! In: a description and names of functions. Out: a table of the prices that stand above the
//! generated functions, the dense 4×4 products beside them.

use std::fmt::Write as _;

use std::io::Read;

use clap::Args;
use serde_json::{Map, Value, json};

use super::functions::Functions;
use super::options::{Format, Robot};
use super::{Answer, Said, json, options};
use crate::chain;
use crate::emit::Listed;
use crate::expand::expand;
use crate::schedule::Price;

/// Count the operations, depth and literals of each function
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen count arm.urdf --functions inverse_dynamics,mass_matrix+bias --format json")]
pub(super) struct Count {
    #[command(flatten)]
    robot: Robot,
    #[command(flatten)]
    functions: Functions,
    /// How the answer is printed
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

impl Count {
    pub(super) fn run(&self, input: &mut dyn Read) -> Said {
        let description = self.robot.description(input)?;
        let request = self.functions.request(&self.robot);
        let chain = chain::build(&description, &request)?;
        let listing = expand(&description, &request, options::item(&description))?;
        let robot = &description.name.text;
        Ok(match self.format {
            Format::Text => Answer {
                output: table(&listing.functions),
                remarks: options::warnings(&description, &chain.report.warnings)
                    + &self.functions.remarks(&listing),
                code: 0,
            },
            Format::Json => Answer {
                output: json::text(&in_json(robot, &listing.functions)),
                ..Answer::default()
            },
        })
    }
}

fn in_json(robot: &str, functions: &[Listed]) -> Value {
    let prices = functions.iter().map(|listed| {
        let Price {
            mul,
            add,
            div,
            sqrt,
            neg,
            sin,
            cos,
            fused,
            depth,
            literals,
            ..
        } = listed.price;
        let (naive_mul, naive_add) = (listed.price.naive_mul, listed.price.naive_add);
        let price = json!({
            "mul": mul, "add": add, "div": div, "sqrt": sqrt, "sin": sin, "cos": cos, "neg": neg,
            "fused": fused, "depth": depth, "literals": literals,
            "naive": { "mul": naive_mul, "add": naive_add },
        });
        (listed.name(), price)
    });
    let prices: Map<String, Value> = prices.collect();
    json!({ "robot": robot, "functions": prices })
}

const HEADS: [&str; 12] = [
    "mul",
    "add",
    "div",
    "sqrt",
    "sin",
    "cos",
    "neg",
    "fused",
    "depth",
    "literals",
    "naive mul",
    "naive add",
];

fn table(functions: &[Listed]) -> String {
    let names: Vec<String> = functions.iter().map(Listed::name).collect();
    let width = names
        .iter()
        .map(|name| name.chars().count())
        .max()
        .unwrap_or(0);
    let mut text = format!("{:width$}", "");
    for head in HEADS {
        text.push_str("  ");
        text.push_str(head);
    }
    text.push('\n');
    for (name, listed) in names.iter().zip(functions) {
        let price = &listed.price;
        // Writing to a string cannot fail.
        let _ = write!(text, "{name:width$}");
        let columns = [
            price.mul,
            price.add,
            price.div,
            price.sqrt,
            price.sin,
            price.cos,
            price.neg,
            price.fused,
            price.depth,
            price.literals,
            price.naive_mul,
            price.naive_add,
        ];
        for (head, number) in HEADS.iter().zip(columns) {
            let column = head.len();
            let _ = write!(text, "  {number:>column$}");
        }
        text.push('\n');
    }
    text
}
