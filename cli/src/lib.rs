//! The command line.
//!
//! Each command has a file of its own. An [`Answer`] is complete before it is printed, so that nothing is on standard
//! output after an error. Only `report`, `site` and `eval`, which may run for minutes, show progress.

mod base_parameters;
mod check;
mod clone;
mod colour;
mod completions;
mod convert;
mod count;
mod eval;
mod expand;
mod fields;
mod fresh;
mod functions;
mod generate;
mod inspect;
mod json;
mod new;
mod options;
mod progress;
mod python;
mod report;
mod show;
mod site;

use std::ffi::OsString;
use std::io::{ErrorKind, Read, Write};
use std::process::ExitCode;
use std::sync::LazyLock;

use clap::{CommandFactory, Parser, Subcommand};

use self::progress::Progress;
use homogen_codegen::builder::FORMAT;
use homogen_codegen::description::denavit_hartenberg;
use homogen_codegen::error::Errors;

/// Runs the program: answers, prints, and returns the exit status.
pub fn run(
    arguments: impl IntoIterator<Item = OsString>,
    input: &mut dyn Read,
    output: &mut dyn Write,
    remarks: &mut dyn Write,
) -> ExitCode {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    // These commands show progress themselves.
    let own = ["eval", "report", "site"];
    let own = (arguments.get(1)).is_some_and(|command| own.iter().any(|name| command == name));
    let progress = (!own).then(Progress::start);
    let answer = answer(arguments, input);
    drop(progress);
    // If this fails, there is nowhere to report it.
    let remarked = if colour::is_wanted() {
        colour::coloured(&answer.remarks)
    } else {
        answer.remarks
    };
    let _ = remarks.write_all(remarked.as_bytes());
    let printed = output
        .write_all(answer.output.as_bytes())
        .and_then(|()| output.flush());
    match printed {
        Ok(()) => ExitCode::from(answer.code),
        // A closed pipe, as in `homogen inspect … | head`, is not an error.
        Err(reason) if reason.kind() == ErrorKind::BrokenPipe => ExitCode::from(answer.code),
        Err(reason) => {
            let _ = writeln!(remarks, "error: cannot write: {reason}");
            ExitCode::FAILURE
        }
    }
}

/// Answer of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Answer {
    /// For standard output; empty after an error.
    pub output: String,
    /// For standard error: errors, warnings, notes.
    pub remarks: String,
    /// Exit status: 0; 1 for an error in the input, 2 for one in the arguments, 3 if a function was left out because of
    /// a fault of homogen.
    pub code: u8,
}

/// The answer to these arguments, the first of which is the program's name.
pub fn answer(arguments: impl IntoIterator<Item = OsString>, input: &mut dyn Read) -> Answer {
    let program = match Program::try_parse_from(arguments) {
        Ok(program) => program,
        Err(usage) => return Answer::of_usage(&usage),
    };
    let outcome = match &program.command {
        Command::Check(check) => check.run(input),
        Command::Inspect(inspect) => inspect.run(input),
        Command::Convert(convert) => convert.run(input),
        Command::Count(count) => count.run(input),
        Command::Eval(eval) => eval.run(input),
        Command::Expand(expand) => expand.run(input),
        Command::Generate(generate) => generate.run(input),
        Command::Python(python) => python.run(input),
        Command::BaseParameters(parameters) => parameters.run(input),
        Command::Show(show) => show.run(input),
        Command::Site(site) => site.run(),
        Command::Report(report) => report.run(),
        Command::New(new) => new.run(input),
        Command::Completions(completions) => completions.run(&mut Program::command()),
    };
    outcome.unwrap_or_else(|errors| Answer {
        remarks: errors.to_string(),
        code: 1,
        ..Answer::default()
    })
}

/// Turns the description of a robot into straight-line code for its kinematics and dynamics.
#[derive(Parser)]
#[command(name = "homogen", version, long_version = versions(), after_help = functions::help())]
struct Program {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Check(check::Check),
    Inspect(inspect::Inspect),
    Convert(convert::Convert),
    Count(count::Count),
    Eval(eval::Eval),
    Expand(expand::Expand),
    Generate(generate::Generate),
    Python(python::Python),
    BaseParameters(base_parameters::BaseParameters),
    Show(show::Show),
    Site(site::Site),
    Report(report::Report),
    New(new::New),
    Completions(completions::Completions),
}

/// The versions of the program and of its formats.
fn versions() -> &'static str {
    static VERSIONS: LazyLock<String> = LazyLock::new(|| {
        format!(
            "{}\ngenerated files: format {FORMAT}\nanswers in JSON: version {}\n\
             tables of Denavit and Hartenberg: version {}",
            env!("CARGO_PKG_VERSION"),
            json::VERSION,
            denavit_hartenberg::VERSION
        )
    });
    &VERSIONS
}

/// The answer of a command, or errors.
type Outcome = Result<Answer, Errors>;

impl Answer {
    fn of_usage(usage: &clap::Error) -> Self {
        let text = usage.render().to_string();
        let (output, remarks) = if usage.use_stderr() {
            (String::new(), text)
        } else {
            (text, String::new())
        };
        Self {
            output,
            remarks,
            code: u8::try_from(usage.exit_code()).unwrap_or(2),
        }
    }
}
