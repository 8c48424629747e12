//! The options that all commands share.
//!
//! In: arguments. Out: the description they name and the [`Request`] they make. It never looks at
//! what the description says.

use std::fmt::Write;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use homogen_codegen::chain::Chain;
use homogen_codegen::description::urdf::LARGEST_FILE;
use homogen_codegen::description::{self, Description, Name, Number, inline};
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::formulation::{self, Formulation};
use homogen_codegen::function::Function;
use homogen_codegen::joint::drive::Part;
use homogen_codegen::processor::Processor;
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::wording::visible;

/// Which part of a robot moves, and from where to where.
#[derive(Args, Clone, Debug)]
pub(super) struct Scope {
    /// The link taken as fixed [default: the root]
    #[arg(long, value_name = "LINK")]
    pub(super) base: Option<String>,
    /// Free the base: it moves anyhow, as the joint `root` with seven coordinates (x, y, z, and a
    /// quaternion x, y, z, w) and six velocities in its own frame, linear first
    #[arg(long)]
    pub(super) floating: bool,
    /// The link whose frame poses and Jacobians are of [default: the last link, where there is
    /// only one]
    #[arg(long, value_name = "LINK")]
    pub(super) tip: Option<String>,
    /// Lock every joint that does not move the tip; the bodies stay as mass
    #[arg(long)]
    pub(super) path_only: bool,
    /// Hold a joint still, at 0 or at a given coordinate (rad or m); its body stays as mass
    #[arg(long, value_name = "JOINT[=q]", value_parser = lock)]
    pub(super) lock: Vec<(String, Option<f64>)>,
}

/// Which robot, and which part of it.
#[expect(clippy::struct_excessive_bools, reason = "a switch is a bool")]
#[derive(Args, Clone, Debug)]
pub(super) struct Robot {
    /// A URDF file or a Denavit–Hartenberg table; `-` reads standard input
    pub(super) file: PathBuf,
    #[command(flatten)]
    scope: Scope,
    /// Take a link off with all that it carries, and with their mass
    #[arg(long, value_name = "LINK")]
    drop: Vec<String>,
    /// Close a loop by a joint between two links, as attributes have it:
    /// 'pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.3, 0, 0), to_at: xyz(0.2, 0, 0) }'
    #[arg(long = "loop", value_name = "NAME: TYPE {…}")]
    loops: Vec<String>,
    /// A joint that is driven, where loops move the others
    #[arg(long, value_name = "JOINT")]
    actuated: Vec<String>,
    /// Acceleration of gravity in the base frame (m/s²), or none [default: 0,0,-9.81]
    #[arg(long, value_name = "x,y,z", value_parser = gravity, allow_hyphen_values = true)]
    gravity: Option<Gravity>,
    /// A link on which the surroundings act: inverse and forward dynamics and their derivatives take an
    /// action for each, in its own frame
    #[arg(long, value_name = "LINK,…", value_delimiter = ',')]
    external: Vec<String>,
    /// These actions are in frame 0
    #[arg(long, requires = "external")]
    external_in_frame_0: bool,
    /// Model the friction that the file has, and that of a joint where one is given (N m or N)
    #[arg(long, value_name = "JOINT=f", num_args = 0..=1, require_equals = true)]
    #[arg(default_missing_value = "", value_parser = friction)]
    friction: Vec<Option<Said>>,
    /// Viscous friction of a joint (N m s/rad or N s/m), and all friction that the file has
    #[arg(long, value_name = "JOINT=d", value_parser = said)]
    damping: Vec<Said>,
    /// Model the rotors that the file has, with their gears
    #[arg(long)]
    rotors: bool,
    /// Inertia that a joint feels beside that of the bodies (kg m² or kg), and all rotors that the
    /// file has
    #[arg(long, value_name = "JOINT=a", value_parser = said)]
    armature: Vec<Said>,
    /// Inertia of a joint's rotor (kg m²), which counts times the square of the ratio
    #[arg(long, value_name = "JOINT=j", value_parser = said)]
    rotor: Vec<Said>,
    /// Turns of a rotor for each of its joint [default: what the file says, or 1]
    #[arg(long, value_name = "JOINT=n", value_parser = said)]
    ratio: Vec<Said>,
    /// Keep an angle such as 1.5708 as written instead of taking it for a right angle
    #[arg(long)]
    exact: bool,
    /// Refuse what is doubtful, such as inertias that no body can have, instead of warning
    #[arg(long)]
    strict: bool,
    /// The processor that the functions run on: cortex-m4, cortex-m7, x86-64, x86-64-v3 or aarch64
    /// [default: portable]
    #[arg(long, value_name = "NAME", value_parser = processor)]
    processor: Option<Processor>,
    /// How functions are computed: frame-0, raw, refined=1 (or 0, 2), articulated, merged,
    /// unfused, platform-sines
    /// [default: what the engine chooses]
    #[arg(long, value_name = "WORD,…", value_parser = formulation)]
    formulation: Option<Formulation>,
}

/// How an answer is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    Text,
    Json,
}

/// The type of number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Scalar {
    F32,
    F64,
}

impl Scalar {
    /// How many bytes a number has.
    pub(super) const fn bytes(self) -> usize {
        match self {
            Self::F32 => size_of::<f32>(),
            Self::F64 => size_of::<f64>(),
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Gravity([f64; 3]);

/// A joint, and a number for each of its velocities or for all.
#[derive(Clone, Debug)]
struct Said(String, Vec<f64>);

impl Robot {
    /// Reads the file, and closes the loops.
    pub(super) fn description(&self, input: &mut dyn Read) -> Result<Description, Errors> {
        let mut errors = Errors::new();
        let mut description = self.written(input)?;
        let loops = self.loops.iter().map(String::as_str);
        inline::close(&mut description, loops, &mut errors);
        errors.into_result(description)
    }

    /// The loops that are told beside the file.
    pub(super) fn loops(&self) -> &[String] {
        &self.loops
    }

    /// What is written in the file.
    pub(super) fn written(&self, input: &mut dyn Read) -> Result<Description, Errors> {
        let mut errors = Errors::new();
        let description = if is_standard_input(&self.file) {
            let bytes = read(input)?;
            description::read_bytes(&bytes, STANDARD_INPUT, None, &mut errors)
        } else {
            description::read_file(&self.file, None, &mut errors)
        };
        match description {
            Some(description) => errors.into_result(description),
            None => Err(errors),
        }
    }

    /// What is asked of it, for some functions of the tip and of further frames.
    pub(super) fn request<'a>(
        &self,
        frames: impl IntoIterator<Item = &'a String>,
        functions: Vec<Vec<Function>>,
    ) -> Request {
        let named = |text: &String| Name {
            text: text.clone(),
            place: Place::Unknown,
        };
        let friction = self.friction.iter().flatten();
        let drives = friction.map(|said| (Part::Friction, said));
        let lists = [
            (Part::Damping, &self.damping),
            (Part::Armature, &self.armature),
            (Part::Rotor, &self.rotor),
            (Part::Ratio, &self.ratio),
        ];
        let lists = lists.into_iter();
        let drives =
            drives.chain(lists.flat_map(|(part, list)| list.iter().map(move |said| (part, said))));
        let drives = drives.map(|(part, Said(joint, numbers))| {
            let numbers = numbers.iter().copied().map(number).collect();
            (named(joint), part, numbers)
        });
        let lock = |(joint, at): &(String, Option<f64>)| (named(joint), at.map(number));
        Request {
            base: self.scope.base.as_ref().map(named),
            floating: self.scope.floating,
            tip: self.scope.tip.as_ref().map(named),
            path_only: self.scope.path_only,
            lock: self.scope.lock.iter().map(lock).collect(),
            drop: self.drop.iter().map(named).collect(),
            actuated: self.actuated.iter().map(named).collect(),
            frames: frames.into_iter().map(named).collect(),
            external: self.external.iter().map(named).collect(),
            external_in_frame_0: self.external_in_frame_0,
            friction: !self.friction.is_empty(),
            rotors: self.rotors,
            drives: drives.collect(),
            gravity: self.gravity.map(|gravity| gravity.0.map(number)),
            exact: self.exact,
            strict: self.strict,
            functions,
            formulation: self.formulation.unwrap_or_default(),
            processor: self.processor.unwrap_or_default(),
            ..Request::default()
        }
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

/// What messages call standard input.
pub(super) const STANDARD_INPUT: &str = "<stdin>";

/// Whether a path stands for standard input.
pub(super) fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// All bytes of standard input, which may have no end.
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

/// That a file of states cannot be read.
pub(super) fn unreadable(path: &Path, reason: &io::Error) -> Errors {
    let what = match reason.kind() {
        ErrorKind::NotFound => "there is no such file".to_owned(),
        _ => reason.to_string(),
    };
    mistake(format!("cannot read {}: {what}", path.display()))
}

/// One mistake without a place.
pub(super) fn mistake(message: impl Into<String>) -> Errors {
    let mut errors = Errors::new();
    errors.push(Place::Unknown, message);
    errors
}

/// Doubts as standard error has them.
pub(super) fn warnings(chain: &Chain) -> String {
    let source = &chain.description.source;
    let mut errors = Errors::new();
    if let Some(file) = &source.file {
        errors.set_file(file.clone(), None);
    }
    let mut text = String::new();
    for doubt in &chain.report.warnings {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "warning: {}", errors.locate(doubt));
        if let Some(hint) = &doubt.hint {
            let _ = writeln!(text, "  hint: {}", visible(hint));
        }
    }
    text
}

fn number(value: f64) -> Number {
    Number {
        value,
        ..Number::default()
    }
}

fn finite(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>();
    let number = number.map_err(|_| format!("`{text}` is not a number"))?;
    let finite = number.is_finite().then_some(number);
    finite.ok_or_else(|| format!("`{text}` is not a finite number"))
}

pub(super) fn lock(text: &str) -> Result<(String, Option<f64>), String> {
    match text.rsplit_once('=') {
        Some((joint, at)) => Ok((joint.to_owned(), Some(finite(at)?))),
        None => Ok((text.to_owned(), None)),
    }
}

fn said(text: &str) -> Result<Said, String> {
    let (joint, numbers) = text
        .rsplit_once('=')
        .ok_or_else(|| "a joint and its number have = between them".to_owned())?;
    let numbers = numbers.split(',').map(finite).collect::<Result<_, _>>()?;
    Ok(Said(joint.to_owned(), numbers))
}

fn friction(text: &str) -> Result<Option<Said>, String> {
    if text.is_empty() {
        return Ok(None);
    }
    said(text).map(Some)
}

fn gravity(text: &str) -> Result<Gravity, String> {
    if text == "none" {
        return Ok(Gravity([0.0; 3]));
    }
    let entries: Vec<f64> = text.split(',').map(finite).collect::<Result<_, _>>()?;
    let entries = entries.try_into().map(Gravity);
    entries.map_err(|_| "gravity is three numbers with commas between them, or none".to_owned())
}

fn processor(text: &str) -> Result<Processor, String> {
    Processor::from_name(text).map_err(|hint| format!("there is no such processor\n  hint: {hint}"))
}

/// The words of attributes, with dashes.
fn formulation(text: &str) -> Result<Formulation, String> {
    let mut reader = formulation::Reader::default();
    for item in text.split(',') {
        let (word, value) = match item.split_once('=') {
            Some((word, value)) => (word, Some(value.trim())),
            None => (item, None),
        };
        let word = word.trim().replace('-', "_");
        reader.take(&word, value).map_err(|refusal| {
            let (message, hint) = (refusal.message, refusal.hint);
            format!("{message}\n  hint: {hint}")
                .replace(" = ", "=")
                .replace('_', "-")
        })?;
    }
    Ok(reader.formulation())
}
