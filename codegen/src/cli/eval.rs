//! `homogen eval`: a function's values, without a compiler.
//!
//! In: a description, the name of a function, states. Out: its results, computed by the scheduled
//! program itself in the arithmetic asked for, with the bits of generated code that brings its own sines and
//! fuses no product with a sum; each number in its shortest form that reads back; and
//! every doubt about the description.

use std::fmt::{Display, Write};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::{Map, Value, json};

use super::arithmetic::Own;
use super::functions;
use super::options::{Format, Robot, STANDARD_INPUT, Scalar, is_standard_input, mistake};
use super::states::State;
use super::{Answer, Said, json, options, states};
use crate::chain::Chain;
use crate::check::Check;
use crate::error::{Errors, Place};
use crate::expand;
use crate::expression::Input;
use crate::formulation::Sines;
use crate::function::Function;
use crate::schedule::{Arithmetic, Program, run};
use crate::space::{Entity, Outcome, Quantity, Space, Spaces, Variable};
use crate::wording::visible;

/// Compute a function at given states, without a compiler
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen eval arm.urdf --function inverse_dynamics --states states.json --format json

The states: {\"states\":[{\"q\":[…],\"qd\":[…],\"qdd\":[…],\"tau\":[…]}]}, one number a joint, in the
order of `homogen check`; keys that the function does not need may be absent. Actions from outside are
\"actions\":[[c_x, c_y, c_z, f_x, f_y, f_z], …], one a link in the order of --external.")]
pub(super) struct Eval {
    #[command(flatten)]
    robot: Robot,
    /// The function, by its name in generated code
    #[arg(long, value_name = "NAME", value_parser = functions::function)]
    function: Function,
    /// A file of states; `-` reads standard input
    #[arg(long, value_name = "FILE")]
    states: PathBuf,
    /// The link whose pose or Jacobian is wanted, instead of the tip's
    #[arg(long, alias = "frames", value_name = "LINK")]
    frame: Option<String>,
    /// The arithmetic
    #[arg(long, value_enum, default_value = "f64")]
    scalar: Scalar,
    /// How the answer is printed
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

impl Eval {
    pub(super) fn run(&self, input: &mut dyn Read) -> Said {
        if is_standard_input(&self.robot.file) && is_standard_input(&self.states) {
            return Err(mistake(
                "description and states cannot both be standard input",
            ));
        }
        let function = self.function;
        let description = self.robot.description(input)?;
        let mut request = self.robot.request(&self.frame, vec![vec![function]]);
        request.scalar = self.scalar.into();
        let chain = expand::understand(&description, &request)?;
        let (text, file) = self.text(input)?;
        let arguments = function.arguments_with(chain.spaces().actions() > 0);
        let states = states::read(&text, &file, &arguments, chain.spaces())?;

        // Further frames come after the tip's.
        let frame = chain.frames.len().saturating_sub(1);
        expand::check_size(&chain)?;
        let program = expand::program_for(
            request.processor,
            request.formulation,
            &chain,
            &[function],
            frame,
            self.scalar.into(),
        )?;
        Check::of(&description, &request, &chain)?.judge(
            &[function],
            frame,
            &program,
            request.scalar,
        )?;
        let results = self.results(&program, (&arguments, request.formulation.sines), &states)?;
        Ok(match self.format {
            Format::Text => Answer {
                output: in_text(&chain, function, &results),
                remarks: options::warnings(&description, &chain.report.warnings),
                code: 0,
            },
            Format::Json => Answer {
                output: json::answer(self.in_json(&chain, frame, &results)),
                ..Answer::default()
            },
        })
    }

    /// The states' text and what messages call it.
    fn text(&self, input: &mut dyn Read) -> Result<(String, String), Errors> {
        let path = &self.states;
        if is_standard_input(path) {
            let text = String::from_utf8(options::read(input)?);
            let text = text.map_err(|_| mistake("<stdin> is not written in UTF-8"))?;
            return Ok((text, STANDARD_INPUT.to_owned()));
        }
        let name = path.file_name().map_or(path.as_path(), Path::new);
        match std::fs::read_to_string(path) {
            Ok(text) => Ok((text, name.display().to_string())),
            Err(reason) => {
                let what = match reason.kind() {
                    ErrorKind::NotFound => "there is no such file".to_owned(),
                    _ => reason.to_string(),
                };
                Err(mistake(format!("cannot read {}: {what}", path.display())))
            }
        }
    }

    fn results(
        &self,
        program: &Program,
        (arguments, sines): (&[Variable], Sines),
        states: &[State],
    ) -> Result<Vec<Vec<f64>>, Errors> {
        let mut errors = Errors::new();
        let mut results = Vec::with_capacity(states.len());
        for (index, state) in states.iter().enumerate() {
            let numbers = match (self.scalar, sines) {
                (Scalar::F32, Sines::Own) => numbers::<Own<f32>>(program, arguments, state),
                (Scalar::F64, Sines::Own) => numbers::<Own<f64>>(program, arguments, state),
                (Scalar::F32, Sines::Platform) => numbers::<f32>(program, arguments, state),
                (Scalar::F64, Sines::Platform) => numbers::<f64>(program, arguments, state),
            };
            if numbers.iter().any(|number| !number.is_finite()) {
                let message = format!("state {index}: a result is too large for {:?}", self.scalar);
                errors.push(Place::Unknown, message.to_lowercase());
            }
            results.push(numbers);
        }
        errors.into_result(results)
    }

    fn in_json(&self, chain: &Chain, frame: usize, results: &[Vec<f64>]) -> Value {
        let spaces = chain.spaces();
        let result = self.function.result();
        let names = |space| spaces.names(space).collect::<Value>();
        let mut answer = Map::new();
        answer.insert("function".into(), json!(self.function.name()));
        answer.insert("coordinates".into(), names(Space::Coordinates));
        answer.insert("velocities".into(), names(Space::Velocities));
        answer.insert("joints".into(), json!(chain.report.joints));
        if (result.parts()).any(|(_, part)| part.over.contains(&Space::Constraints)) {
            answer.insert("constraints".into(), names(Space::Constraints));
        }
        if self.function.of_a_frame() {
            answer.insert("base".into(), json!(chain.report.base));
            answer.insert("frame".into(), json!(chain.frames[frame].name));
        }
        let shapes = result
            .parts()
            .map(|(_, part)| json!(dimensions(&part, spaces)));
        answer.insert("shape".into(), by_name(result, shapes));
        if let Some(rows) = result.parts().find_map(|(_, part)| names_of_rows(&part)) {
            answer.insert("rows".into(), json!(rows));
        }
        answer.insert("warnings".into(), json::warnings(&chain.report.warnings));
        let results = results.iter().map(|numbers| {
            let parts = result.parts().zip(result.split(spaces, numbers));
            let values =
                parts.map(
                    |((_, part), numbers)| match (rows(&part, spaces, numbers), numbers) {
                        (Some(rows), _) => json!(rows),
                        (None, [number]) if part.over.is_empty() => json!(number),
                        (None, numbers) => json!(numbers),
                    },
                );
            by_name(result, values)
        });
        answer.insert("results".into(), results.collect());
        Value::Object(answer)
    }
}

/// What the rows of a matrix are whose columns are of joints.
fn names_of_rows(quantity: &Quantity) -> Option<&'static [&'static str]> {
    const SIX: [&str; 6] = [
        "angular_x",
        "angular_y",
        "angular_z",
        "linear_x",
        "linear_y",
        "linear_z",
    ];
    match (quantity.over, quantity.entity) {
        ([], _) => None,
        (_, Entity::Screw | Entity::Momentum) => Some(&SIX),
        (_, Entity::Vector) => Some(&["x", "y", "z"]),
        _ => None,
    }
}

/// A value of each quantity: an object where there are several, and the only one where there are not.
fn by_name(result: Outcome, values: impl Iterator<Item = Value>) -> Value {
    let parts = result.parts().zip(values);
    parts.fold(Value::Null, |mut all, ((name, _), value)| match name {
        Some(name) => {
            all[name] = value;
            all
        }
        None => value,
    })
}

/// The results as the `f64`s that print like them.
fn numbers<T: Arithmetic + Display>(
    program: &Program,
    arguments: &[Variable],
    state: &State,
) -> Vec<f64> {
    let results = run(program, |input| match input {
        Input::Variable(wanted, k) => {
            let index = arguments.iter().position(|&argument| argument == wanted);
            let index = index.expect("a program reads the arguments of its function");
            T::literal(state[index][usize::from(k)])
        }
        Input::Parameter(..) => unreachable!("the command line has no run-time parameters"),
    });
    // By way of the shortest digits: 0.1 in f32 is to be printed as 0.1, and not as all the digits
    // that the same number has in f64.
    let shortest = |number: T| number.to_string().parse().unwrap_or(f64::NAN);
    results.into_iter().map(shortest).collect()
}

/// The rows and columns of a result: matrices of four rows whole, what each joint has as columns.
fn dimensions(quantity: &Quantity, spaces: &Spaces) -> Vec<usize> {
    let mut lengths = quantity.lengths(spaces);
    let dimensions = quantity.entity.dimensions();
    match (quantity.over, dimensions) {
        ([], [6] | [3, 4]) => lengths.extend([4, 4]),
        ([], dimensions) => lengths.extend(dimensions),
        (_, &[rows]) => lengths.insert(0, rows),
        _ => {}
    }
    lengths
}

/// The rows of a matrix, whole; none of a vector.
fn rows(quantity: &Quantity, spaces: &Spaces, numbers: &[f64]) -> Option<Vec<Vec<f64>>> {
    let under = |last: [f64; 4]| {
        let rows = numbers.chunks(4).map(<[f64]>::to_vec);
        rows.chain([last.to_vec()]).collect()
    };
    // The vector of a skew block, the last column, and what stands under it.
    let skew = |last: [f64; 3]| {
        let (w, v) = (&numbers[..3], &numbers[3..]);
        let [x, y, z] = last;
        vec![
            vec![0.0, -w[2], w[1], v[0]],
            vec![w[2], 0.0, -w[0], v[1]],
            vec![-w[1], w[0], 0.0, v[2]],
            vec![x, y, z, 0.0],
        ]
    };
    if let (&[_], &[each]) = (quantity.over, quantity.entity.dimensions()) {
        let row = |row: usize| numbers.iter().skip(row).step_by(each).copied().collect();
        return Some((0..each).map(row).collect());
    }
    Some(match quantity.entity {
        Entity::Number => {
            let &[_, columns] = &*quantity.lengths(spaces) else {
                return None;
            };
            numbers
                .chunks(columns.max(1))
                .map(<[f64]>::to_vec)
                .collect()
        }
        Entity::Pose => under([0.0, 0.0, 0.0, 1.0]),
        Entity::Acceleration => under([0.0; 4]),
        Entity::Velocity | Entity::Screw => skew([0.0; 3]),
        Entity::Momentum | Entity::Action => skew([-numbers[3], -numbers[4], -numbers[5]]),
        Entity::Point | Entity::Vector => return None,
    })
}

fn in_text(chain: &Chain, function: Function, results: &[Vec<f64>]) -> String {
    let spaces = chain.spaces();
    let result = function.result();
    let mut text = String::new();
    for (index, numbers) in results.iter().enumerate() {
        for ((part, quantity), numbers) in result.parts().zip(result.split(spaces, numbers)) {
            // Writing to a string cannot fail.
            let _ = match part {
                Some(part) => writeln!(text, "{part} of {} of state {index}", function.name()),
                None => writeln!(text, "{} of state {index}", function.name()),
            };
            quantity_in_text(&mut text, spaces, &quantity, numbers);
        }
    }
    text
}

fn quantity_in_text(text: &mut String, spaces: &Spaces, quantity: &Quantity, numbers: &[f64]) {
    if let Some(rows) = rows(quantity, spaces, numbers) {
        for row in rows {
            let row: Vec<String> = row.iter().map(|number| format!("{number:>24?}")).collect();
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{}", row.concat());
        }
    } else {
        for (k, number) in numbers.iter().enumerate() {
            let owner = quantity.owner(spaces, k);
            let entry = owner.map(|(space, entry)| &spaces.entries(space)[entry]);
            let name = entry.map_or(String::new(), |entry| format!("  {}", visible(&entry.name)));
            let _ = writeln!(text, "{number:>24?}{name}");
        }
    }
}
