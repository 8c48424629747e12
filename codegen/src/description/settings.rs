//! Reads settings in attributes and in the braces of `chain!`.
//!
//! The forms are `key = value` (or `key: value`), `key(…)` and `key`. They become a [`Request`] and the path of the
//! description. Names of links and joints are not resolved here.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Ident, Lit, LitInt, LitStr, Path, Token, token};

use super::tokens::{self, Parsed, diagnostic, diagnostic_with_hint};
use super::{Name, Number, number};
use crate::error::{Diagnostic, Errors, Place};
use crate::formulation::{self, Formulation};
use crate::function::Function;
use crate::processor::Processor;
use crate::real::Real;
use crate::request::Request;
use crate::request::setting::{self, Setting, SettingForm};
use crate::wording::{known, quoted};

/// The words of inline descriptions.
const DESCRIBE: [&str; 4] = ["link", "joint", "loop", "denavit_hartenberg"];

/// Words of the attribute: the keys of settings, and the words of an inline description.
pub(super) fn words() -> Vec<&'static str> {
    let keys = setting::of_attributes().map(|setting| setting.key);
    keys.chain(DESCRIBE).collect()
}

/// The settings read so far.
#[derive(Default)]
pub(super) struct Settings {
    pub(super) request: Request,
    /// The files of descriptions; more than one is an error.
    pub(super) files: Vec<LitStr>,
    /// The keys read so far.
    pub(super) seen: Vec<Ident>,
}

impl Settings {
    /// The place of a key.
    pub(super) fn span(&self, key: &str) -> Option<Span> {
        let found = self.seen.iter().find(|seen| *seen == key);
        found.map(Ident::span)
    }
}

/// Reads one setting.
pub(super) fn read(input: ParseStream, settings: &mut Settings, errors: &mut Errors) -> Parsed<()> {
    let key = tokens::word(input)?;
    let text = key.to_string();
    let mut known_keys = setting::of_attributes();
    let Some(setting) = known_keys.find(|setting| setting.key == text) else {
        let message = format!("unknown key {}", quoted(&text));
        let mut flags = setting::of_attributes();
        let meant = flags.find(|setting| setting.flag_name() == text);
        let meant = meant.map_or(&*text, |setting| setting.key);
        let hint = known(meant, "keys", &words());
        return Err(diagnostic_with_hint(key.span(), message, hint));
    };
    if settings.span(&text).is_some() {
        let message = format!("the key {} occurs twice", quoted(&text));
        return Err(diagnostic(key.span(), message));
    }
    settings.seen.push(key.clone());
    let request = &mut settings.request;
    let list = || in_parentheses(input, &text, setting.example);
    let value = || tokens::separator(input, &key).map(|()| input);
    match setting.form {
        SettingForm::File => {
            let path = string(value()?, setting, "the path of a file")?;
            settings.files.push(path);
        }
        SettingForm::Arguments => request.arguments = tokens::list(&list()?, argument)?,
        SettingForm::Packages => {
            request.packages = tokens::list(&list()?, |input| {
                let name = tokens::name(input)?;
                tokens::separator(input, &key)?;
                let folder = string(input, setting, "folders of packages")?;
                Ok((name, folder.value()))
            })?;
        }
        SettingForm::Switch(of) => *of(request) = true,
        SettingForm::Name(of) => *of(request) = Some(tokens::name(value()?)?),
        SettingForm::Names(of) => *of(request) = tokens::list(&list()?, tokens::name)?,
        SettingForm::Positions(of) => {
            *of(request) = tokens::list(&list()?, |input| position(input, &key))?;
        }
        SettingForm::Actuator(_, Some(alone)) if !has_value(input) && !input.peek(token::Paren) => {
            *alone(request) = true;
        }
        SettingForm::Actuator(quantity, _) => {
            let joints = tokens::list(&list()?, |input| {
                let name = tokens::name(input)?;
                tokens::separator(input, &key)?;
                let subject = format!("the {key} of joint {}", quoted(&name.text));
                Ok((name, quantity, tokens::one_or_more(input, &subject)?))
            })?;
            request.actuators.extend(joints);
        }
        SettingForm::Pairs(of, alone) => {
            *alone(request) = true;
            if input.peek(token::Paren) {
                *of(request) = tokens::list(&list()?, |input| {
                    let first = tokens::name(input)?;
                    tokens::separator(input, &key)?;
                    Ok([first, tokens::name(input)?])
                })?;
            }
        }
        SettingForm::External(_) => {
            tokens::list(&list()?, |input| external(input, request))?;
        }
        SettingForm::Gravity => request.gravity = Some(gravity(value()?, setting)?),
        SettingForm::Count(of, what) => *of(request) = Some(count(value()?, setting, what)?),
        SettingForm::Functions => request.functions = functions(&list()?, errors)?,
        SettingForm::Formulation => request.formulation = formulation(&list()?, errors)?,
        SettingForm::Processor => request.processor = processor(value()?, setting)?,
        SettingForm::Scalar => request.scalar = scalar(value()?)?,
        SettingForm::Runtime => request.runtime = Some(path(value()?, setting)?),
        // In attributes, loops are read with links and joints; steps are of files in C.
        SettingForm::Loops | SettingForm::Steps => {}
    }
    Ok(())
}

fn in_parentheses<'a>(input: ParseStream<'a>, key: &str, example: &str) -> Parsed<ParseBuffer<'a>> {
    if !input.peek(token::Paren) {
        let message = format!("`{key}` needs a list in parentheses");
        let hint = format!("write {example}");
        return Err(diagnostic_with_hint(input.span(), message, hint));
    }
    Ok(tokens::parentheses(input)?)
}

/// True if a value follows a key or a name.
fn has_value(input: ParseStream) -> bool {
    input.peek(Token![=]) || input.peek(Token![:])
}

/// An error of a setting that needs another value.
fn needs(span: Span, setting: &Setting, what: &str) -> Diagnostic {
    let message = format!("`{}` needs {what}", setting.key);
    diagnostic_with_hint(span, message, format!("write {}", setting.example))
}

fn string(input: ParseStream, setting: &Setting, what: &str) -> Parsed<LitStr> {
    if !input.peek(LitStr) {
        return Err(needs(input.span(), setting, what));
    }
    Ok(input.parse()?)
}

/// An argument of a xacro file: a string, or a number or a boolean as it is written.
fn argument(input: ParseStream) -> Parsed<(Name, String)> {
    let name = tokens::name(input)?;
    tokens::separator(input, &Ident::new("arguments", Span::call_site()))?;
    let sign = if input.peek(Token![-]) {
        input.parse::<Token![-]>()?;
        "-"
    } else {
        ""
    };
    let value = match input.parse::<Lit>()? {
        Lit::Str(text) => text.value(),
        other => other.to_token_stream().to_string(),
    };
    Ok((name, format!("{sign}{value}")))
}

/// A joint, with a coordinate if there is one.
fn position(input: ParseStream, key: &Ident) -> Parsed<(Name, Option<Number>)> {
    let name = tokens::name(input)?;
    if !has_value(input) {
        return Ok((name, None));
    }
    tokens::separator(input, key)?;
    let subject = format!("the position of joint {}", quoted(&name.text));
    let value = tokens::number(input, &subject)?;
    Ok((name, Some(value)))
}

/// A link with an external wrench, or `frame = 0`.
fn external(input: ParseStream, request: &mut Request) -> Parsed<()> {
    let name = tokens::name(input)?;
    if !has_value(input) {
        request.external.push(name);
        return Ok(());
    }
    let hint = "write external(gripper), or external(gripper, frame = 0)";
    tokens::separator(input, &Ident::new("frame", Span::call_site()))?;
    let span = input.span();
    let zero = tokens::number(input, "the frame of the wrenches")?.value == 0.0;
    if name.text == "frame" && zero {
        request.external_in_frame_0 = true;
        return Ok(());
    }
    let message = "external wrenches are in the frames of their links, or all in frame 0";
    Err(diagnostic_with_hint(span, message, hint))
}

/// A vector, or `none`.
fn gravity(input: ParseStream, setting: &Setting) -> Parsed<[Number; 3]> {
    if input.peek(token::Bracket) {
        return tokens::vector(input, setting.key);
    }
    let span = input.span();
    if input.peek(Ident) && tokens::word(input)? == "none" {
        return Ok([0.0; 3].map(|zero| number::computed(zero, Place::Token(span))));
    }
    let hint = format!("write {}", setting.example);
    let message = "gravity must be a vector or none";
    Err(diagnostic_with_hint(span, message, hint))
}

fn scalar(input: ParseStream) -> Parsed<Real> {
    let word = tokens::word(input)?;
    let mut scalars = Real::ALL.into_iter();
    scalars.find(|scalar| word == scalar.name()).ok_or_else(|| {
        let text = word.to_string();
        let message = format!("unknown scalar {}", quoted(&text));
        let hint = known(&text, "scalars", &Real::ALL.map(Real::name));
        diagnostic_with_hint(word.span(), message, hint)
    })
}

fn processor(input: ParseStream, setting: &Setting) -> Parsed<Processor> {
    let name = string(input, setting, "the name of a processor")?;
    Processor::from_name(&name.value()).map_err(|hint| {
        let message = format!("unknown processor {}", quoted(&name.value()));
        diagnostic_with_hint(name.span(), message, hint)
    })
}

fn count(input: ParseStream, setting: &Setting, what: &str) -> Parsed<usize> {
    let span = input.span();
    let count = if input.peek(LitInt) {
        input.parse::<LitInt>()?.base10_parse().ok()
    } else {
        None
    };
    let count = count.filter(|&count| count > 0);
    count.ok_or_else(|| needs(span, setting, what))
}

/// The word for all functions that the robot can have.
const ALL: &str = "all";

/// Functions, alone or as `all_of(…)`; `None` for `all`. Each unknown one is an error.
fn functions(input: ParseStream, errors: &mut Errors) -> Parsed<Vec<Vec<Function>>> {
    let mut items: Vec<Vec<Function>> = Vec::new();
    let mut all: Option<Ident> = None;
    let span = input.span();
    tokens::list(input, |input| {
        let word = tokens::word(input)?;
        let mut item = Vec::new();
        if word == ALL {
            all = Some(word);
            return Ok(());
        }
        if word == "all_of" {
            let content = in_parentheses(input, "all_of", "all_of(mass_matrix, bias)")?;
            if content.is_empty() {
                tokens::push(errors, diagnostic(word.span(), "`all_of` is empty"));
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
            let message = format!("{} occurs twice", quoted(&word.to_string()));
            tokens::push(errors, diagnostic(word.span(), message));
        } else if !item.is_empty() {
            items.push(item);
        }
        Ok(())
    })?;
    match all {
        Some(word) if !items.is_empty() => {
            let message = "`all` stands for every function";
            let hint = "name functions, or write generate(all)";
            tokens::push(errors, diagnostic_with_hint(word.span(), message, hint));
        }
        None if items.is_empty() && errors.is_empty() => {
            let problem = diagnostic_with_hint(span, "`generate` names no function", HOW_TO_ASK);
            tokens::push(errors, problem);
        }
        _ => {}
    }
    Ok(items)
}

/// Hint with the syntax of `generate`.
pub(crate) const HOW_TO_ASK: &str = "write generate(inverse_dynamics, mass_matrix), or generate(all) for every function \
                                     that the robot can have";

fn add(word: &Ident, item: &mut Vec<Function>, errors: &mut Errors) {
    let text = word.to_string();
    let problem = match Function::from_name(&text) {
        Some(function) if item.contains(&function) => {
            diagnostic(word.span(), format!("{} occurs twice", quoted(&text)))
        }
        Some(function) => {
            item.push(function);
            return;
        }
        None => diagnostic_with_hint(
            word.span(),
            format!("unknown function {}", quoted(&text)),
            known(&text, "functions", &Function::names()),
        ),
    };
    tokens::push(errors, problem);
}

/// Words of a formulation, some with a value; each unknown or contradictory one is an error.
fn formulation(input: ParseStream, errors: &mut Errors) -> Parsed<Formulation> {
    let mut reader = formulation::FormulationReader::default();
    tokens::list(input, |input| {
        let word = tokens::word(input)?;
        let value = if has_value(input) {
            tokens::separator(input, &word)?;
            Some(input.parse::<TokenTree>()?.to_string())
        } else {
            None
        };
        if let Err(refusal) = reader.take(&word.to_string(), value.as_deref()) {
            let problem = diagnostic_with_hint(word.span(), refusal.message, refusal.hint);
            tokens::push(errors, problem);
        }
        Ok(())
    })?;
    Ok(reader.formulation())
}

/// The path of the runtime crate, as a string or as tokens.
fn path(input: ParseStream, setting: &Setting) -> Parsed<TokenStream> {
    if !input.peek(LitStr) {
        return Ok(input.call(Path::parse_mod_style)?.into_token_stream());
    }
    let literal: LitStr = input.parse()?;
    match literal.parse_with(Path::parse_mod_style) {
        Ok(path) => Ok(path.into_token_stream()),
        Err(_) => Err(diagnostic_with_hint(
            literal.span(),
            format!("{} is not a path", quoted(&literal.value())),
            format!("write {}", setting.example),
        )),
    }
}
