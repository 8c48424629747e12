//! Fuzzing: damaged descriptions, and the outcome of reading and expanding each.
//!
//! In: a seed and a number. Out: the input of that number, the same on every machine, and its outcome: reported
//! mistakes, code, or a fault of the engine. A fault is a panic (integer overflow in debug builds included), a refusal
//! without a message, a literal that is not finite, an output with hidden characters, or an expansion that fails the
//! engine's own check. Time and memory are measured by the program `fire`.

mod damage;
mod originals;
mod splinters;
mod texts;

use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use homogen_cli as cli;
use homogen_codegen::description::{Description, inline, read_bytes};
use homogen_codegen::error::Errors;
use homogen_codegen::expand::expand;
use homogen_codegen::print::rust::{self, CoreFunctions, Item, Library};
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::Operand;
use homogen_codegen::{Function, chain};
use proc_macro2::TokenStream;

use crate::states::Random;

/// The language of a description.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// URDF.
    Urdf,
    /// URDF with the macros of ROS.
    Xacro,
    /// The format of MuJoCo.
    Mjcf,
    /// The format of Gazebo and Drake.
    Sdf,
    /// A Denavit–Hartenberg table.
    Table,
    /// The grammar of `chain!`.
    Inline,
}

/// A damaged description.
#[derive(Clone, Debug)]
pub struct Input {
    /// The language of the original.
    pub language: Language,
    /// The bytes after the damage.
    pub bytes: Vec<u8>,
}

/// The outcome of an input without a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Mistakes were reported.
    Refused,
    /// The requested functions were generated.
    Expanded,
    /// The description was read, but is too large to expand here, or cannot have the requested functions.
    Understood,
}

/// Part of the engine's message when an expansion fails its check.
const OWN_FAULT: &str = "this is a fault of homogen";

/// Joints of the largest robot that is expanded.
const SMALL: usize = 8;

/// Bytes of the largest text that is given to the command line.
const SHORT: usize = 20_000;

/// The input of a number.
#[must_use]
pub fn input(seed: u64, number: u64) -> Input {
    let mut random = random(seed, number);
    let (language, text) = originals::choose(&mut random);
    let bytes = damage::damage(language, text, &mut random);
    Input { language, bytes }
}

/// Reads and expands an input.
///
/// # Errors
/// A fault of the engine.
pub fn attempt(seed: u64, number: u64, input: &Input) -> Result<Outcome, String> {
    let mut random = random(seed, !number);
    let went = catch_unwind(AssertUnwindSafe(|| take(input, &mut random)));
    went.unwrap_or_else(|panic| {
        let words = panic.downcast_ref::<String>().map(String::as_str);
        let words = words.or(panic.downcast_ref::<&str>().copied());
        Err(format!("panic: {}", words.unwrap_or("of another kind")))
    })
}

fn random(seed: u64, number: u64) -> Random {
    Random::new(seed ^ number.wrapping_mul(0xd134_2543_de82_ef95))
}

fn take(input: &Input, random: &mut Random) -> Result<Outcome, String> {
    let mut errors = Errors::new();
    let read = |file: &str, errors: &mut Errors| read_bytes(&input.bytes, file, None, errors);
    let (description, mut request) = match input.language {
        Language::Inline => {
            // A macro only gets what Rust can split into tokens.
            let text = String::from_utf8_lossy(&input.bytes);
            let Ok(tokens) = text.parse::<TokenStream>() else {
                return Ok(Outcome::Refused);
            };
            let item = inline::read(tokens, Path::new("/no/such/folder"), &mut errors);
            item.map_or((None, None), |item| (item.description, Some(item.request)))
        }
        Language::Urdf => (read("arm.urdf", &mut errors), None),
        Language::Xacro => (read("arm.urdf.xacro", &mut errors), None),
        Language::Mjcf => (read("arm.xml", &mut errors), None),
        Language::Sdf => (read("arm.sdf", &mut errors), None),
        Language::Table => (read("arm.dh", &mut errors), None),
    };
    if input.language != Language::Inline && input.bytes.len() < SHORT {
        answers(&input.bytes)?;
    }
    let Some(description) = description else {
        return refused(&errors, "nothing was read");
    };
    if request.is_none() || random.chance(2) {
        request = Some(asked(random, &description));
    }
    let request = request.unwrap_or_default();
    // Front ends stop at a misread description, but the chain must not panic on it.
    let built = chain::build(&description, &request);
    if !errors.is_empty() {
        return refused(&errors, "misread");
    }
    match built {
        Err(errors) => refused(&errors, "no chain"),
        Ok(chain) if chain.joints.len() > SMALL => Ok(Outcome::Understood),
        Ok(_) => expanded(&description, &request),
    }
}

fn expanded(description: &Description, request: &Request) -> Result<Outcome, String> {
    let module = match expand(description, request) {
        Ok(module) => module,
        Err(errors) => {
            refused(&errors, "no code")?;
            return Ok(Outcome::Understood);
        }
    };
    for generated in &module.functions {
        let literal = generated
            .program
            .operands()
            .find(|operand| matches!(operand, Operand::Literal(value) if !value.is_finite()));
        if let Some(literal) = literal {
            return Err(format!("{} reads {literal:?}", generated.name()));
        }
    }
    let library = Library::Core(CoreFunctions::default());
    if rust::print(&module, &Item::named_after("arm"), &library).is_empty() {
        return Err("no code, and no message".to_owned());
    }
    Ok(Outcome::Expanded)
}

fn refused(errors: &Errors, what: &str) -> Result<Outcome, String> {
    let text = errors.to_string();
    if errors.is_empty() {
        return Err(format!("{what}, and no message"));
    }
    if text.contains(OWN_FAULT) {
        return Err(text);
    }
    shown(&text)?;
    Ok(Outcome::Refused)
}

/// Checks the answers of the command line for a file.
fn answers(bytes: &[u8]) -> Result<(), String> {
    for format in ["text", "json"] {
        let words = ["homogen", "check", "-", "--format", format].map(OsString::from);
        let answer = cli::answer(words, &mut &*bytes);
        shown(&answer.output)?;
        shown(&answer.remarks)?;
        if answer.output.is_empty() == answer.remarks.is_empty() {
            return Err(format!("check answers twice or not at all: {answer:?}"));
        }
    }
    Ok(())
}

/// An error if an output contains a control character or a hidden one.
fn shown(text: &str) -> Result<(), String> {
    let hidden = |c: &char| {
        *c != '\n'
            && (c.is_control()
                || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}'))
    };
    match text.chars().find(hidden) {
        Some(letter) => Err(format!(
            "an output holds {}: {text}",
            letter.escape_unicode()
        )),
        None => Ok(()),
    }
}

/// A random request, with names of the robot.
fn asked(random: &mut Random, description: &Description) -> Request {
    let links: Vec<_> = description
        .links
        .iter()
        .map(|link| link.name.clone())
        .collect();
    let joints: Vec<_> = description
        .joints
        .iter()
        .map(|joint| joint.name.clone())
        .collect();
    let mut request = Request {
        functions: vec![vec![*random.choose(&Function::ALL)]],
        scalar: *random.choose(&[Real::F32, Real::F64]),
        strict: random.chance(8),
        exact: random.chance(4),
        path_only: random.chance(8),
        ..Request::default()
    };
    if let Some(tip) = links.last().filter(|_| !random.chance(4)) {
        request.tip = Some(tip.clone());
    }
    if !links.is_empty() && random.chance(8) {
        request.drop.push(random.choose(&links).clone());
        request.base = Some(random.choose(&links).clone());
    }
    if !joints.is_empty() && random.chance(8) {
        request.lock.push((random.choose(&joints).clone(), None));
    }
    request
}
