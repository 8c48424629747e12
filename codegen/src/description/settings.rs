//! What is asked for, as it is written in attributes and in the braces of `chain!`.
//!
//! In: `key = value` (or `key: value`), `key(…)` or `key`. Out: a [`Request`] and the file that is
//! named, if one is. It never looks at the description, so it knows no link from a joint.

mod forces;

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::ParseStream;
use syn::{Ident, LitInt, LitStr, Path, Token, token};

use super::number;
use super::tokens::{self, Parsed, complaint, complaint_with_hint};
use crate::error::{Errors, Place};
use crate::formulation::{self, Formulation};
use crate::function::Function;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::Request;
use crate::wording::{known, quoted};

/// What may stand in the attribute: the keys of settings, in the order of the documentation, and
/// the words that describe a robot in place.
pub(super) const WORDS: [&str; 32] = [
    "urdf",
    "dh",
    "base",
    "floating",
    "tip",
    "path_only",
    "lock",
    "drop",
    "frames",
    "actuated",
    "gravity",
    "friction",
    "damping",
    "armature",
    "rotor",
    "ratio",
    "rotors",
    "external",
    "exact",
    "strict",
    "scalar",
    "generate",
    "formulation",
    "processor",
    "batch",
    "prepare",
    "section",
    "crate",
    "link",
    "joint",
    "loop",
    "denavit_hartenberg",
];

/// The types of numbers.
pub(super) const SCALARS: [&str; 3] = ["f32", "f64", "generic"];

/// How many of the words are keys of settings.
const KEYS: usize = 28;

/// What was set, and where.
#[derive(Default)]
pub(super) struct Settings {
    pub(super) request: Request,
    /// The files that describe the robot; more than one is a mistake.
    pub(super) files: Vec<LitStr>,
    /// The keys that were given.
    pub(super) seen: Vec<Ident>,
}

impl Settings {
    /// Where a key was given.
    pub(super) fn span(&self, key: &str) -> Option<Span> {
        let found = self.seen.iter().find(|seen| *seen == key);
        found.map(Ident::span)
    }
}

/// Reads one setting.
pub(super) fn read(input: ParseStream, settings: &mut Settings, errors: &mut Errors) -> Parsed<()> {
    let key = tokens::word(input)?;
    let text = key.to_string();
    if !WORDS[..KEYS].contains(&text.as_str()) {
        let message = format!("unknown key {}", quoted(&text));
        // The command line's word.
        let meant = if text == "functions" {
            "generate"
        } else {
            &text
        };
        let hint = known(meant, "keys", &WORDS);
        return Err(complaint_with_hint(key.span(), message, hint));
    }
    if settings.span(&text).is_some() {
        let message = format!("the key {} is given twice", quoted(&text));
        return Err(complaint(key.span(), message));
    }
    settings.seen.push(key.clone());
    let request = &mut settings.request;
    match text.as_str() {
        "urdf" | "dh" => {
            tokens::separator(input, &key)?;
            if !input.peek(LitStr) {
                let message = format!("`{key}` needs the path of a file");
                let hint = format!("write {key} = \"arm.{key}\"");
                return Err(complaint_with_hint(input.span(), message, hint));
            }
            settings.files.push(input.parse()?);
        }
        "base" => {
            tokens::separator(input, &key)?;
            request.base = Some(tokens::name(input)?);
        }
        "tip" => {
            tokens::separator(input, &key)?;
            request.tip = Some(tokens::name(input)?);
        }
        "floating" => request.floating = true,
        "path_only" => request.path_only = true,
        "exact" => request.exact = true,
        "strict" => request.strict = true,
        "batch" => request.batch = true,
        "prepare" => request.prepare = true,
        "lock" => {
            let content = in_parentheses(input, &key, "lock(joint, other = 0.3)")?;
            request.lock = tokens::list(&content, |input| {
                let name = tokens::name(input)?;
                let value = if input.peek(Token![=]) || input.peek(Token![:]) {
                    tokens::separator(input, &key)?;
                    let subject = format!("the position of joint {}", quoted(&name.text));
                    Some(tokens::number(input, &subject)?)
                } else {
                    None
                };
                Ok((name, value))
            })?;
        }
        "drop" => {
            let content = in_parentheses(input, &key, "drop(link)")?;
            request.drop = tokens::list(&content, tokens::name)?;
        }
        "frames" => {
            let content = in_parentheses(input, &key, "frames(link, other)")?;
            request.frames = tokens::list(&content, tokens::name)?;
        }
        "actuated" => {
            let content = in_parentheses(input, &key, "actuated(joint, other)")?;
            request.actuated = tokens::list(&content, tokens::name)?;
        }
        "gravity" => {
            tokens::separator(input, &key)?;
            request.gravity = Some(gravity(input)?);
        }
        word if forces::KEYS.contains(&word) => forces::read(input, &key, request)?,
        "scalar" => {
            tokens::separator(input, &key)?;
            request.scalar = scalar(input)?;
        }
        "generate" => {
            let content = in_parentheses(input, &key, "generate(inverse_dynamics)")?;
            request.functions = functions(&content, errors)?;
        }
        "formulation" => {
            let content = in_parentheses(input, &key, "formulation(raw, refined = 1)")?;
            request.formulation = formulation(&content, errors)?;
        }
        "processor" => {
            tokens::separator(input, &key)?;
            request.processor = processor(input)?;
        }
        "section" => {
            tokens::separator(input, &key)?;
            request.section = Some(section(input)?);
        }
        // The last of the known keys is `crate`.
        _ => {
            tokens::separator(input, &key)?;
            request.runtime = Some(path(input)?);
        }
    }
    Ok(())
}

fn in_parentheses<'a>(
    input: ParseStream<'a>,
    key: &Ident,
    example: &str,
) -> Parsed<syn::parse::ParseBuffer<'a>> {
    if !input.peek(token::Paren) {
        let message = format!("`{key}` needs a list in parentheses");
        let hint = format!("write {example}");
        return Err(complaint_with_hint(input.span(), message, hint));
    }
    Ok(tokens::parentheses(input)?)
}

/// A vector, or `none`.
fn gravity(input: ParseStream) -> Parsed<[super::Number; 3]> {
    if input.peek(token::Bracket) {
        return tokens::vector(input, "gravity");
    }
    let span = input.span();
    if input.peek(Ident) && tokens::word(input)? == "none" {
        return Ok([0.0; 3].map(|zero| number::computed(zero, Place::Token(span))));
    }
    let hint = "write gravity = [0.0, 0.0, -9.81], or gravity = none";
    Err(complaint_with_hint(
        span,
        "gravity is neither a vector nor none",
        hint,
    ))
}

fn scalar(input: ParseStream) -> Parsed<Real> {
    let word = tokens::word(input)?;
    match word.to_string().as_str() {
        "f32" => Ok(Real::F32),
        "f64" => Ok(Real::F64),
        "generic" => Ok(Real::Generic),
        other => Err(complaint_with_hint(
            word.span(),
            format!("unknown scalar {}", quoted(other)),
            known(other, "scalars", &SCALARS),
        )),
    }
}

/// The name of a processor, as a string.
fn processor(input: ParseStream) -> Parsed<Processor> {
    if !input.peek(LitStr) {
        let hint = "write processor = \"cortex-m4\"";
        return Err(complaint_with_hint(
            input.span(),
            "`processor` needs the name of a processor",
            hint,
        ));
    }
    let name: LitStr = input.parse()?;
    Processor::from_name(&name.value()).map_err(|hint| {
        let message = format!("unknown processor {}", quoted(&name.value()));
        complaint_with_hint(name.span(), message, hint)
    })
}

/// How many statements a compiled function may have.
fn section(input: ParseStream) -> Parsed<usize> {
    let span = input.span();
    let count = if input.peek(LitInt) {
        input.parse::<LitInt>()?.base10_parse().ok()
    } else {
        None
    };
    count.filter(|&count| count > 0).ok_or_else(|| {
        complaint_with_hint(
            span,
            "`section` needs the most statements of one compiled function",
            "write section = 2000",
        )
    })
}

/// Functions, alone or as `all_of(…)`; complains of each unknown one.
fn functions(input: ParseStream, errors: &mut Errors) -> Parsed<Vec<Vec<Function>>> {
    let mut items: Vec<Vec<Function>> = Vec::new();
    tokens::list(input, |input| {
        let word = tokens::word(input)?;
        let mut item = Vec::new();
        if word == "all_of" {
            let content = in_parentheses(input, &word, "all_of(mass_matrix, bias)")?;
            if content.is_empty() {
                tokens::push(errors, complaint(word.span(), "`all_of` of no functions"));
            }
            tokens::list(&content, |input| {
                let word = tokens::word(input)?;
                add(&word, &mut item, errors);
                Ok(())
            })?;
        } else {
            add(&word, &mut item, errors);
        }
        if items.contains(&item) {
            let message = format!("{} is asked for twice", quoted(&word.to_string()));
            tokens::push(errors, complaint(word.span(), message));
        } else if !item.is_empty() {
            items.push(item);
        }
        Ok(())
    })?;
    Ok(items)
}

fn add(word: &Ident, item: &mut Vec<Function>, errors: &mut Errors) {
    let text = word.to_string();
    let problem = match Function::from_name(&text) {
        Some(function) if item.contains(&function) => {
            complaint(word.span(), format!("{} is asked for twice", quoted(&text)))
        }
        Some(function) => {
            item.push(function);
            return;
        }
        None => complaint_with_hint(
            word.span(),
            format!("unknown function {}", quoted(&text)),
            known(&text, "functions", &Function::names()),
        ),
    };
    tokens::push(errors, problem);
}

/// Words, some with a value; complains of each that is unknown or contradicts another.
fn formulation(input: ParseStream, errors: &mut Errors) -> Parsed<Formulation> {
    let mut reader = formulation::Reader::default();
    tokens::list(input, |input| {
        let word = tokens::word(input)?;
        let value = if input.peek(Token![=]) || input.peek(Token![:]) {
            tokens::separator(input, &word)?;
            Some(input.parse::<TokenTree>()?.to_string())
        } else {
            None
        };
        if let Err(refusal) = reader.take(&word.to_string(), value.as_deref()) {
            let problem = complaint_with_hint(word.span(), refusal.message, refusal.hint);
            tokens::push(errors, problem);
        }
        Ok(())
    })?;
    Ok(reader.formulation())
}

/// A path to the runtime crate, as a string or as tokens.
fn path(input: ParseStream) -> Parsed<TokenStream> {
    if !input.peek(LitStr) {
        return Ok(input.call(Path::parse_mod_style)?.into_token_stream());
    }
    let literal: LitStr = input.parse()?;
    match literal.parse_with(Path::parse_mod_style) {
        Ok(path) => Ok(path.into_token_stream()),
        Err(_) => Err(complaint_with_hint(
            literal.span(),
            format!("{} is not a path", quoted(&literal.value())),
            "write crate = \"::homogen\"",
        )),
    }
}
