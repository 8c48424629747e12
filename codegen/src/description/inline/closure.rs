//! `loop NAME: revolute(z) { from: …, to: …, at: …, to_at: … }`.
//!
//! A joint that closes a loop between two links of the tree. Its axis is in the frames that `at` and `to_at` place on
//! these links. A universal joint has two axes, the first in the frame on `from` and the second in that on `to`; a rod
//! has a length in metres.

use syn::parse::{ParseStream, Parser};
use syn::{Token, token};

use super::{body, joint};
use crate::closure::{ALL, Closure, Definition};
use crate::description::tokens::{self, Parsed, diagnostic, diagnostic_with_hint};
use crate::description::{Loop, Name, Number};
use crate::error::{Diagnostic, Errors, Place};
use crate::wording::{known, quoted};

/// The keys.
pub(in crate::description) const KEYS: [&str; 4] = ["from", "to", "at", "to_at"];

/// The type of a loop, with its axes.
struct Closing {
    closure: Closure,
    axes: [[Number; 3]; 2],
    warnings: Vec<Diagnostic>,
}

/// Reads a loop from a text: the part after the word `loop`.
pub(super) fn read_text(text: &str, errors: &mut Errors) -> Option<(Loop, Vec<Diagnostic>)> {
    let mut found = None;
    let parser = |input: ParseStream| {
        match read(input, errors) {
            Ok(read) => found = read,
            Err(diagnostic) => tokens::push(errors, diagnostic),
        }
        tokens::skip(input, |_| false);
        Ok(())
    };
    if let Err(reason) = parser.parse_str(text) {
        errors.push(
            Place::Unknown,
            format!("{} is not a loop: {reason}", quoted(text)),
        );
    }
    found
}

/// Reads the part after the word `loop`, with its warnings; `None` after a reported error.
pub(super) fn read(
    input: ParseStream,
    errors: &mut Errors,
) -> Parsed<Option<(Loop, Vec<Diagnostic>)>> {
    let name = tokens::name(input)?;
    let subject = format!("loop {}", quoted(&name.text));
    if !input.peek(Token![:]) {
        let hint = "write loop pin: revolute(z) { from: coupler, to: rocker }";
        let message = format!("expected `:` after {subject}");
        return Err(diagnostic_with_hint(input.span(), message, hint));
    }
    input.parse::<Token![:]>()?;
    let closing = closing(input, &subject, errors)?;
    body::end(input, &subject)?;
    let (mut from, mut to) = (None, None);
    let (mut at, mut to_at) = (Vec::new(), Vec::new());
    tokens::fields(input, &subject, &KEYS, errors, |key, input| {
        match key {
            "from" => from = Some(tokens::name(input)?),
            "to" => to = Some(tokens::name(input)?),
            "at" => at = joint::placement(input, &subject)?,
            _ => to_at = joint::placement(input, &subject)?,
        }
        Ok(())
    })?;
    let mut missing = |end: &Option<Name>, key: &str| {
        if end.is_none() {
            let message = format!("{subject} has no link `{key}`");
            errors.push_with_hint(name.place, message, format!("name it, {key}: rocker"));
        }
    };
    missing(&from, "from");
    missing(&to, "to");
    let (Some(closing), Some(from), Some(to)) = (closing, from, to) else {
        return Ok(None);
    };
    let Closing {
        closure,
        axes,
        warnings,
    } = closing;
    let described = Loop {
        name,
        closure,
        from,
        to,
        at,
        to_at,
        axes,
    };
    Ok(Some((described, warnings)))
}

/// `revolute(z)`, `universal(x, y)`, `rod(0.3)`, `spherical`; `None` after a reported error.
fn closing(input: ParseStream, subject: &str, errors: &mut Errors) -> Parsed<Option<Closing>> {
    let word = tokens::word(input)?;
    let text = word.to_string();
    let Some(kind) = Definition::named(&text) else {
        let message = format!("{subject} has the unknown type {}", quoted(&text));
        let hint = known(&text, "types", &ALL.map(|kind| kind.word));
        tokens::push(errors, diagnostic_with_hint(word.span(), message, hint));
        if input.peek(token::Paren) {
            let content = tokens::parentheses(input)?;
            tokens::skip(&content, |_| false);
        }
        return Ok(None);
    };
    let wants = kind.axes > 0 || kind.has_length();
    if !input.peek(token::Paren) {
        if wants {
            let inside = match kind.axes {
                0 => "0.3",
                1 => "z",
                _ => "x, y",
            };
            let what = if kind.has_length() { "length" } else { "axis" };
            let message = format!("{subject} has no {what}");
            let hint = format!("write {word}({inside})");
            tokens::push(errors, diagnostic_with_hint(word.span(), message, hint));
            return Ok(None);
        }
        return Ok(Some(Closing {
            closure: kind.with_length(|| Ok::<_, Diagnostic>(Number::default()))?,
            axes: [[Number::default(); 3]; 2],
            warnings: Vec::new(),
        }));
    }
    let content = tokens::parentheses(input)?;
    let closing = in_parentheses(&content, kind, subject);
    tokens::skip(&content, |_| false);
    Ok(closing
        .map_err(|diagnostic| tokens::push(errors, diagnostic))
        .ok())
}

fn in_parentheses(input: ParseStream, kind: &Definition, subject: &str) -> Parsed<Closing> {
    if kind.axes == 0 && !kind.has_length() {
        let message = format!("{subject} is {} and has no axis", kind.word);
        return Err(diagnostic(input.span(), message));
    }
    let mut axes = [[Number::default(); 3]; 2];
    let mut warnings = Vec::new();
    for k in 0..kind.axes {
        if k > 0 {
            let span = input.span();
            let message = format!("{subject} has no second axis");
            let hint = format!("write {}(x, y)", kind.word);
            input
                .parse::<Token![,]>()
                .map_err(|_| diagnostic_with_hint(span, message, hint))?;
        }
        let (axis, warning) = joint::direction(input, subject)?;
        // A single axis is that of both frames.
        axes[k..].fill(axis);
        warnings.extend(warning);
    }
    let closure = kind.with_length(|| -> Parsed<Number> {
        let span = input.span();
        let length = tokens::number(input, &format!("the length of {subject}"))?;
        if length.value > 0.0 {
            return Ok(length);
        }
        let message = format!("the length of {subject} is not positive: {}", length.value);
        let hint = "write spherical to join two points";
        Err(diagnostic_with_hint(span, message, hint))
    })?;
    if !input.is_empty() {
        let message = format!("expected `)` after the axes of {subject}");
        return Err(diagnostic(input.span(), message));
    }
    Ok(Closing {
        closure,
        axes,
        warnings,
    })
}
