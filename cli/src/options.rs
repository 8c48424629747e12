//! Options that all commands share: the description and the [`Request`].

use std::fmt::Write;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, ValueEnum};

use homogen_codegen::chain::Chain;
use homogen_codegen::description::Given;
use homogen_codegen::description::LARGEST_FILE;
use homogen_codegen::description::{self, Description, Source, inline};
use homogen_codegen::error::{Diagnostic, Errors, Place};
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::{ROBOT, SCOPE, SETTINGS, SOURCE, Setting, SettingForm};
use homogen_codegen::wording::visible;

/// Options of groups of settings, each with its value as written.
#[derive(Clone, Debug)]
pub(super) struct Asked<const GROUPS: u8>(Vec<(&'static Setting, String)>);

impl<const GROUPS: u8> Asked<GROUPS> {
    /// A request with the values of these options.
    pub(super) fn and(&self, mut request: Request) -> Request {
        for (setting, value) in &self.0 {
            // Errors were reported when the arguments were read.
            let _ = setting.take(value, &mut request);
        }
        request
    }
}

fn settings(groups: u8) -> impl Iterator<Item = &'static Setting> {
    let settings = SETTINGS.iter();
    settings.filter(move |setting| setting.group & groups != 0)
}

/// The clap argument of a setting. A switch has an empty value.
fn argument(setting: &'static Setting) -> Arg {
    let name = setting.flag_name();
    let take = |text: &str| {
        let taken = setting.take(text, &mut Request::default());
        taken.map(|()| text.to_owned())
    };
    let mut argument = Arg::new(setting.key)
        .long(name.clone())
        .help(setting.help)
        .value_parser(take);
    if let Some(other) = setting.needs {
        argument = argument.requires(other);
    }
    if let SettingForm::Switch(_) = setting.form {
        // Prevents clap from reading true or false.
        let argument = argument.action(ArgAction::Set);
        return argument.num_args(0).default_missing_value("");
    }
    argument = argument.value_name(setting.value);
    match setting.form {
        SettingForm::Gravity => argument.allow_hyphen_values(true),
        _ if setting.may_stand_alone() => argument
            .action(ArgAction::Append)
            .num_args(0..=1)
            .require_equals(true)
            .default_missing_value(""),
        _ if setting.has_list() => {
            let of_one = name.strip_suffix('s').map(ToOwned::to_owned);
            let argument = argument.action(ArgAction::Append).value_delimiter(',');
            argument.aliases(of_one)
        }
        SettingForm::Names(_)
        | SettingForm::Positions(_)
        | SettingForm::Actuator(..)
        | SettingForm::Arguments
        | SettingForm::Packages
        | SettingForm::Loops => argument.action(ArgAction::Append),
        _ => argument,
    }
}

impl<const GROUPS: u8> Args for Asked<GROUPS> {
    fn augment_args(command: Command) -> Command {
        command.args(settings(GROUPS).map(argument))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl<const GROUPS: u8> FromArgMatches for Asked<GROUPS> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let given = settings(GROUPS).flat_map(|setting| {
            let values = matches.get_many::<String>(setting.key);
            let values = values.into_iter().flatten().cloned();
            values.map(move |value| (setting, value))
        });
        Ok(Self(given.collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The robot, and the part of it.
#[derive(Args, Clone, Debug)]
pub(super) struct Robot {
    /// A URDF, xacro, MJCF or SDF file, or a Denavit–Hartenberg table; `-` reads standard input
    pub(super) file: PathBuf,
    #[command(flatten)]
    pub(super) asked: Asked<{ SOURCE | SCOPE | ROBOT }>,
}

/// Format of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Text,
    Json,
}

/// The type of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Scalar {
    F32,
    F64,
}

impl Scalar {
    /// Number of bytes of a number.
    pub(super) const fn bytes(self) -> usize {
        match self {
            Self::F32 => size_of::<f32>(),
            Self::F64 => size_of::<f64>(),
        }
    }
}

impl Robot {
    /// Reads the file, and adds the loops.
    pub(super) fn description(&self, input: &mut dyn Read) -> Result<Description, Errors> {
        let mut errors = Errors::new();
        let mut description = self.written(input)?;
        let loops = self.request().loops;
        inline::close(
            &mut description,
            loops.iter().map(String::as_str),
            &mut errors,
        );
        errors.into_result(description)
    }

    /// The description as in the file.
    pub(super) fn written(&self, input: &mut dyn Read) -> Result<Description, Errors> {
        written(&self.file, &self.request(), input)
    }

    /// The request.
    pub(super) fn request(&self) -> Request {
        self.asked.and(Request::default())
    }
}

/// The description in a file or on standard input, with the arguments and packages of a request.
pub(super) fn written(
    file: &Path,
    request: &Request,
    input: &mut dyn Read,
) -> Result<Description, Errors> {
    let mut errors = Errors::new();
    let description = if is_standard_input(file) {
        let bytes = read(input)?;
        description::read_bytes(&bytes, STANDARD_INPUT, None, &mut errors)
    } else {
        let given = Given::of(request, Path::new(""));
        description::read_file_with(file, &given, None, &mut errors)
    };
    match description {
        Some(description) => errors.into_result(description),
        None => Err(errors),
    }
}

impl From<Scalar> for Real {
    fn from(scalar: Scalar) -> Self {
        match scalar {
            Scalar::F32 => Self::F32,
            Scalar::F64 => Self::F64,
        }
    }
}

/// The name of standard input in messages.
pub(super) const STANDARD_INPUT: &str = "<stdin>";

/// True if a path means standard input.
pub(super) fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// All bytes of standard input, with a limit.
pub(super) fn read(input: &mut dyn Read) -> Result<Vec<u8>, Errors> {
    let mut bytes = Vec::new();
    let most = LARGEST_FILE as u64;
    match input.take(most + 1).read_to_end(&mut bytes) {
        Ok(_) if bytes.len() <= LARGEST_FILE => Ok(bytes),
        Ok(_) => Err(mistake(format!(
            "{STANDARD_INPUT} is larger than {} MB",
            most >> 20
        ))),
        Err(reason) => Err(mistake(format!("cannot read {STANDARD_INPUT}: {reason}"))),
    }
}

/// The error of an unreadable file of states.
pub(super) fn unreadable(path: &Path, reason: &io::Error) -> Errors {
    let what = match reason.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => reason.to_string(),
    };
    mistake(format!("cannot read {}: {what}", path.display()))
}

/// An error without a place.
pub(super) fn mistake(message: impl Into<String>) -> Errors {
    let mut errors = Errors::new();
    errors.push(Place::Unknown, message);
    errors
}

/// Warnings about a robot, as printed on standard error.
pub(super) fn warnings(chain: &Chain) -> String {
    warnings_of(&chain.description.source, &chain.report.warnings)
}

/// Warnings about a description, as printed on standard error.
pub(super) fn warnings_of(source: &Source, warnings: &[Diagnostic]) -> String {
    remarks(&source.errors(), warnings)
}

/// Warnings with the names of their files, which a list of errors has.
pub(super) fn remarks(errors: &Errors, warnings: &[Diagnostic]) -> String {
    let mut text = String::new();
    for warning in warnings {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "warning: {}", errors.locate(warning));
        if let Some(hint) = &warning.hint {
            let _ = writeln!(text, "  hint: {}", visible(hint));
        }
    }
    text
}
