//! `homogen eval`: values of a function, without a compiler.
//!
//! The scheduled program is run in `f64` or `f32` at the given states. Results equal, bit for bit, those of generated
//! code with its own sines and without fused operations. Standard output has the shortest form of each number that
//! reads back; files have the exact number. Warnings of the description are printed.

mod answer;
mod listed;
mod npy;
mod results;
mod states;
#[cfg(test)]
mod tests;
mod values;

use std::ffi::OsString;
use std::io::Read;

use clap::Args;

use self::answer::Layout;
use self::results::{Sink, Wanted, write};
use self::states::{Source, States};
use self::values::Values;
use super::options::{Format, Robot, Scalar, is_standard_input, mistake};
use super::progress::Progress;
use super::{Answer, Outcome, json, options};
use homogen_codegen::check::Check;
use homogen_codegen::description::Name;
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::expand;
use homogen_codegen::function::Function;
use homogen_codegen::plan::{self, Programs};
use homogen_codegen::request::setting::text::function;
use homogen_codegen::space::FrameId;

/// Compute a function at given states, without a compiler
#[derive(Args, Clone, Debug)]
#[command(after_help = "\
Example:
  homogen eval arm.urdf --function inverse_dynamics --states states.json --format json
  homogen eval arm.urdf --function gravity --states q.npy --output gravity.npy
  homogen eval arm.urdf --function bias --states q=q.npy --states qd=qd.npy --output bias.npy

States: {\"states\":[{\"q\":[…],\"qd\":[…],\"qdd\":[…],\"tau\":[…]}]}, one number for each joint, in the order of
`homogen check`; keys that the function does not need may be missing. External wrenches are
\"actions\":[[c_x, c_y, c_z, f_x, f_y, f_z], …], one for each link in the order of --external.
In .npy files these are arrays with one row for each state; with .npy as output, memory does not grow with the
number of states.")]
pub(super) struct Eval {
    #[command(flatten)]
    robot: Robot,
    /// The function, by its name in generated code
    #[arg(long, value_name = "NAME", value_parser = function)]
    function: Function,
    /// A file of states, .json or .npy; for each of several arguments NAME=FILE, in .npy; `-` reads JSON from
    /// standard input
    #[arg(long, value_name = "FILE", required = true)]
    states: Vec<OsString>,
    /// The file to write, .npy or .json; for each of several results NAME=FILE, in .npy [default: standard output]
    #[arg(long, short, value_name = "FILE", conflicts_with = "format")]
    output: Vec<OsString>,
    /// The link of the pose or Jacobian, instead of the end effector
    #[arg(long, alias = "frames", value_name = "LINK")]
    frame: Option<String>,
    /// The arithmetic
    #[arg(long, value_enum, default_value = "f64")]
    scalar: Scalar,
    /// Format of the answer
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

/// Maximum number of numbers of states and results in memory, unless one state has more.
const NUMBERS: usize = 1 << 20;

impl Eval {
    pub(super) fn run(&self, input: &mut dyn Read) -> Outcome {
        let progress = Progress::start();
        let from_input = |file: &OsString| is_standard_input(file.as_ref());
        if is_standard_input(&self.robot.file) && self.states.iter().any(from_input) {
            return Err(mistake(
                "the description and the states cannot both be standard input",
            ));
        }
        let function = self.function;
        let wanted = Wanted::of(&self.output, function)?;
        let description = self.robot.description(input)?;
        let mut request = self.robot.request();
        request.functions.push(vec![function]);
        request.frames.extend(self.frame.as_deref().map(Name::from));
        request.scalar = self.scalar.into();
        let chain = expand::understand(&description, &request)?;
        let chain = expand::identified_if_asked(chain);
        let arguments = function.arguments_with(chain.spaces().actions() > 0);
        let mut states = Source::open(&self.states, &arguments, chain.spaces(), input)?;

        // A further frame comes after that of the end effector.
        let frame = chain.frames.ids().last().unwrap_or(FrameId::FIRST);
        plan::check_size(&chain)?;
        let programs = Programs::of(&chain);
        let program = plan::plan(&programs, vec![function], frame)?.program;
        Check::of(&chain)?.judge_program(&[function], frame, &program, request.scalar)?;
        let values = Values {
            program: &program,
            arguments: &arguments,
            scalar: self.scalar,
            sines: request.formulation.sines,
        };
        let layout = Layout::of(&chain, function, frame, self.scalar);
        let count = states.count();
        let numbers = arguments
            .iter()
            .map(|argument| chain.spaces().len(argument.space()));
        let numbers = program.results.len() + numbers.sum::<usize>();
        let work = Work {
            values,
            piece: (NUMBERS / numbers.max(1)).max(1),
            progress,
        };
        let remarks = options::warnings(&chain);
        let mut sink = match &wanted {
            Wanted::Shown => {
                let results = work.listed(&mut states, &layout)?;
                if self.format == Format::Json {
                    return Ok(Answer {
                        output: json::answer(layout.in_json(&results)),
                        ..Answer::default()
                    });
                }
                return Ok(Answer {
                    output: layout.in_text(&results),
                    remarks,
                    code: 0,
                });
            }
            Wanted::Text(path) => {
                let results = work.listed(&mut states, &layout)?;
                write(path, &json::answer(layout.in_json(&results)))?;
                return Ok(Answer::default());
            }
            Wanted::Arrays(paths) => Sink::begin(paths, &layout, count)?,
        };
        work.each_piece(&mut states, |states, results| {
            sink.write(&layout, results, states.count)
        })?;
        sink.finish()?;
        Ok(Answer {
            remarks,
            ..Answer::default()
        })
    }
}

/// A function at states, computed in pieces.
struct Work<'p> {
    values: Values<'p>,
    /// Number of states in a piece.
    piece: usize,
    progress: Progress,
}

impl Work<'_> {
    /// Calls a function with the states and the results of each piece.
    fn each_piece(
        &self,
        states: &mut Source,
        mut take: impl FnMut(&States, &[f64]) -> Result<(), Errors>,
    ) -> Result<(), Errors> {
        let count = states.count();
        self.progress.of(count);
        for first in (0..count).step_by(self.piece) {
            let piece = states.next(self.piece.min(count - first))?;
            take(&piece, &self.values.at(&piece))?;
            self.progress.add(piece.count);
        }
        Ok(())
    }

    /// The results at all states as text; an argument or result that is not finite is an error.
    fn listed(&self, states: &mut Source, layout: &Layout<'_>) -> Result<Vec<Vec<f64>>, Errors> {
        let mut errors = Errors::new();
        let mut all = Vec::new();
        self.each_piece(states, |states, results| {
            let each = self.values.program.results.len();
            for state in 0..states.count {
                let numbers = &results[state * each..][..each];
                let index = all.len();
                if !states.are_finite(state) {
                    let message = format!("state {index}: an argument is not a finite number");
                    errors.push_with_hint(
                        Place::Unknown,
                        message,
                        "write to a file, which can have such results: --output FILE",
                    );
                } else if numbers.iter().any(|number| !number.is_finite()) {
                    let message = format!(
                        "state {index}: a result is too large for {:?}",
                        self.values.scalar
                    );
                    errors.push(Place::Unknown, message.to_lowercase());
                }
                all.push(layout.shortest(numbers));
            }
            Ok(())
        })?;
        errors.into_result(all)
    }
}
