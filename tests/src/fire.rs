//! Descriptions under fire: texts that somebody's editor, script, disk or malice has changed, and what
//! the engine makes of them.
//!
//! In: a seed and a number. Out: the input of that number, the same on every machine, and what became
//! of it: a mistake that was told, code, or a fault of the engine. A fault is a panic (an overflow is
//! one where overflows are checked), a refusal that says nothing, a literal that is not finite, an
//! output that hides something, or an expansion that found itself wrong. It never measures time or
//! memory; the program `fire` does.

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
use homogen_codegen::print::rust::{self, Item, Library, World};
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::Operand;
use homogen_codegen::{Function, chain};
use proc_macro2::TokenStream;

use crate::states::Random;

/// What the text of a robot is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// URDF.
    Urdf,
    /// A Denavit–Hartenberg table.
    Table,
    /// The grammar of `chain!`.
    Inline,
}

/// A text under fire.
#[derive(Clone, Debug)]
pub struct Input {
    /// What it was written in.
    pub language: Language,
    /// What is left of it.
    pub bytes: Vec<u8>,
}

/// What became of an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Every mistake was told.
    Refused,
    /// A robot, and the functions asked for.
    Expanded,
    /// A robot that is too large to be expanded in passing, or without the functions asked for.
    Understood,
}

/// How the engine says that an expansion found itself wrong.
const OWN_FAULT: &str = "this is a fault of homogen";

/// The most joints of a robot that is expanded.
const SMALL: usize = 8;

/// The largest text whose answers on the command line are looked at.
const SHORT: usize = 20_000;

/// The input of a number.
#[must_use]
pub fn input(seed: u64, number: u64) -> Input {
    let mut random = random(seed, number);
    let (language, text) = originals::choose(&mut random);
    let bytes = damage::damage(language, text, &mut random);
    Input { language, bytes }
}

/// Takes the input of a number as far as it goes.
///
/// # Errors
/// What the engine did that it must not do.
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
    let (description, mut request) = match input.language {
        Language::Inline => {
            // What is no Rust does not reach a macro.
            let text = String::from_utf8_lossy(&input.bytes);
            let Ok(tokens) = text.parse::<TokenStream>() else {
                return Ok(Outcome::Refused);
            };
            let item = inline::read(tokens, Path::new("/no/such/folder"), &mut errors);
            item.map_or((None, None), |item| (item.description, Some(item.request)))
        }
        Language::Urdf => (
            read_bytes(&input.bytes, "arm.urdf", None, &mut errors),
            None,
        ),
        Language::Table => (read_bytes(&input.bytes, "arm.dh", None, &mut errors), None),
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
    // What was misread goes no further in a door, but must do no harm to the chain.
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
    let world = World::Core(Library::default());
    if rust::print(&module, &Item::named_after("arm"), &world).is_empty() {
        return Err("no code, and nothing said".to_owned());
    }
    Ok(Outcome::Expanded)
}

fn refused(errors: &Errors, what: &str) -> Result<Outcome, String> {
    let text = errors.to_string();
    if errors.is_empty() {
        return Err(format!("{what}, and nothing said"));
    }
    if text.contains(OWN_FAULT) {
        return Err(text);
    }
    shown(&text)?;
    Ok(Outcome::Refused)
}

/// What the command line says of a file.
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

/// Whether an output obeys nothing that a name says.
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

/// A request that fits the robot, more or less.
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
