//! `denavit_hartenberg(modified) { shoulder: revolute { a: …, alpha: …, d: …, theta: … } … }`.
//!
//! The rows become links and joints, as in a table in a file. Missing lengths and angles are zero.

use proc_macro2::Span;
use syn::Token;
use syn::parse::ParseStream;

use super::body::{self, Inertia};
use super::joint::InlineLimits;
use crate::description::denavit_hartenberg::{self, Convention, Row};
use crate::description::kind;
use crate::description::tokens::{self, Parsed, diagnostic_with_hint};
use crate::description::{Joint, Link, Name, Number, number};
use crate::error::{Errors, Place};
use crate::wording::quoted;

/// The keys of a row, mass and inertia first.
pub(in crate::description) const KEYS: [&str; 12] = [
    "mass",
    "com",
    "inertia",
    "inertia_rpy",
    "a",
    "alpha",
    "d",
    "theta",
    "pitch",
    "link",
    "limits",
    "velocity",
];

/// Reads a table after the word `denavit_hartenberg`.
pub(super) fn read(
    input: ParseStream,
    word: Span,
    errors: &mut Errors,
) -> Parsed<(Vec<Link>, Vec<Joint>)> {
    let hint = "write denavit_hartenberg(modified) { … }, or (standard)";
    let missing = |span| diagnostic_with_hint(span, "the table names no convention", hint);
    let content = tokens::parentheses(input).map_err(|_| missing(word))?;
    let name = tokens::word(&content).map_err(|_| missing(content.span()))?;
    tokens::skip(&content, |_| false);
    let convention = Convention::from_name(&name.to_string()).unwrap_or_else(|(message, hint)| {
        tokens::push(errors, diagnostic_with_hint(name.span(), message, hint));
        Convention::Modified
    });
    let content = tokens::braces(input)?;
    let mut rows = Vec::new();
    while !content.is_empty() {
        if content.peek(Token![,]) || content.peek(Token![;]) {
            tokens::skip(&content, |_| true);
            continue;
        }
        match row(&content, errors) {
            Ok(row) => rows.extend(row),
            Err(diagnostic) => {
                tokens::push(errors, diagnostic);
                tokens::skip(&content, |token| {
                    tokens::is_braces(token) || tokens::is_punctuation(token, ';')
                });
            }
        }
    }
    Ok(denavit_hartenberg::assemble(
        convention,
        rows,
        Place::Token(name.span()),
    ))
}

/// One row; `None` if its type is unknown.
fn row(input: ParseStream, errors: &mut Errors) -> Parsed<Option<Row>> {
    let joint = tokens::name(input)?;
    let subject = format!("joint {}", quoted(&joint.text));
    if !input.peek(Token![:]) {
        let message = format!("expected `:` after {subject}");
        let hint = "write elbow: revolute { a: 0.3 }";
        return Err(diagnostic_with_hint(input.span(), message, hint));
    }
    input.parse::<Token![:]>()?;
    let word = tokens::word(input)?;
    let kind = kind::of_one_axis(&word.to_string(), &subject)
        .map_err(|(message, hint)| {
            tokens::push(errors, diagnostic_with_hint(word.span(), message, hint));
        })
        .ok();
    body::end(input, &subject)?;

    let zero = number::computed(0.0, joint.place);
    let [mut a, mut alpha, mut d, mut theta] = [zero; 4];
    let mut pitch: Option<Number> = None;
    let mut link: Option<Name> = None;
    let mut limits = InlineLimits::default();
    let mut inertia = Inertia::default();
    tokens::fields(input, &subject, &KEYS, errors, |key, input| {
        let part = format!("{key} of {subject}");
        match key {
            "a" => a = tokens::number(input, &part)?,
            "alpha" => alpha = tokens::number(input, &part)?,
            "d" => d = tokens::number(input, &part)?,
            "theta" => theta = tokens::number(input, &part)?,
            "pitch" => pitch = Some(tokens::number(input, &part)?),
            "link" => link = Some(tokens::name(input)?),
            "limits" | "velocity" => limits.read(key, input, &subject)?,
            _ => inertia.read(key, input, &format!("the link of {subject}"))?,
        }
        Ok(())
    })?;
    let subject_link = format!("the link of {subject}");
    let inertial = inertia.finish(&joint, &subject_link, errors);
    let kind = kind.and_then(|kind| {
        kind.with_pitch(|| {
            pitch.ok_or_else(|| {
                let hint = "add pitch: 0.01, in metres per radian";
                let message = format!("{subject} has no pitch");
                tokens::push(errors, diagnostic_with_hint(word.span(), message, hint));
            })
        })
        .ok()
    });
    Ok(kind.map(|kind| Row {
        joint,
        link,
        kind,
        a,
        alpha,
        d,
        theta,
        inertial,
        limits: limits.finish(),
    }))
}
