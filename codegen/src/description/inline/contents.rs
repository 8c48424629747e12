//! Entries of an inline description, and the description that they make.
//!
//! In: tokens. Out: [`Contents`], and a [`Description`] of its links, joints and loops. It reads no files.

use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Ident, Token};

use super::joint::{self, InlineJoint};
use super::{body, closure, composite, table};
use crate::description::settings::{self, Settings};
use crate::description::tokens::{self, Parsed, diagnostic};
use crate::description::{Description, Link, Loop, Name, Source, Unmodelled, names};
use crate::error::{Diagnostic, Errors, Place};
use crate::wording::quoted;

/// The entries between the braces or the parentheses.
#[derive(Default)]
pub(in crate::description) struct Contents {
    pub(in crate::description) settings: Settings,
    pub(super) elements: Vec<InlineElement>,
    /// Loops, each with its warnings.
    pub(super) loops: Vec<(Loop, Vec<Diagnostic>)>,
}

/// An element of the robot, in the order of the text.
pub(super) enum InlineElement {
    Link(Link),
    Joint(InlineJoint),
    /// A row of a table: a joint whose links are known.
    Row(crate::description::Joint),
}

/// Reads settings, links, joints and loops up to the end.
pub(in crate::description) fn entries(
    input: ParseStream,
    contents: &mut Contents,
    errors: &mut Errors,
) {
    while !input.is_empty() {
        if input.peek(Token![,]) || input.peek(Token![;]) {
            tokens::skip(input, |_| true);
            continue;
        }
        if let Err(diagnostic) = entry(input, contents, errors) {
            tokens::push(errors, diagnostic);
            tokens::skip(input, |token| {
                tokens::is_braces(token)
                    || tokens::is_punctuation(token, ',')
                    || tokens::is_punctuation(token, ';')
            });
        }
    }
}

fn entry(input: ParseStream, contents: &mut Contents, errors: &mut Errors) -> Parsed<()> {
    let ahead = input.fork();
    let word = tokens::word(&ahead).map_err(|_| {
        diagnostic(
            input.span(),
            "expected a setting, `link`, `joint` or `loop`",
        )
    })?;
    let is_setting = ahead.peek(Token![=]) || ahead.peek(Token![:]);
    match word.to_string().as_str() {
        "link" if !is_setting => {
            tokens::word(input)?;
            contents
                .elements
                .push(InlineElement::Link(link(input, errors)?));
        }
        "joint" if !is_setting => {
            tokens::word(input)?;
            let name = joint::named(input)?;
            let joints = if composite::is_next(input) {
                composite::read(&name, input, errors)?
            } else {
                vec![joint::of(name, &joint::KEYS, input, errors)?]
            };
            for joint in joints {
                // Terms written in the description itself are always modelled.
                contents.settings.request.model(&joint.actuator);
                contents.elements.push(InlineElement::Joint(joint));
            }
        }
        "loop" if !is_setting => {
            tokens::word(input)?;
            contents.loops.extend(closure::read(input, errors)?);
        }
        "denavit_hartenberg" if !is_setting => {
            let word = tokens::word(input)?;
            let (links, joints) = table::read(input, word.span(), errors)?;
            contents
                .elements
                .extend(links.into_iter().map(InlineElement::Link));
            contents
                .elements
                .extend(joints.into_iter().map(InlineElement::Row));
        }
        _ => {
            settings::read(input, &mut contents.settings, errors)?;
            if !input.is_empty() && !input.peek(Token![,]) && !input.peek(Token![;]) {
                let message = format!("expected `,` after the setting `{word}`");
                let diagnostic = diagnostic(input.span(), message);
                if !input.peek(Ident::peek_any) {
                    return Err(diagnostic);
                }
                // Only the comma is missing, so the next entry can be read.
                tokens::push(errors, diagnostic);
            }
        }
    }
    Ok(())
}

/// `link NAME { mass: …, com: […], inertia: […] }` or `link NAME;`.
fn link(input: ParseStream, errors: &mut Errors) -> Parsed<Link> {
    let name = tokens::name(input)?;
    let subject = format!("link {}", quoted(&name.text));
    body::end(input, &subject)?;
    let mut inertial = body::Inertia::default();
    tokens::fields(input, &subject, &body::INERTIA, errors, |key, input| {
        inertial.read(key, input, &subject)
    })?;
    Ok(Link {
        inertial: inertial.finish(&name, &subject, errors),
        name,
    })
}

/// Adds loops and their warnings to those of the file.
pub(super) fn add(
    description: &mut Description,
    loops: Vec<(Loop, Vec<Diagnostic>)>,
    errors: &mut Errors,
) {
    if loops.is_empty() {
        return;
    }
    for (described, warnings) in loops {
        description.warnings.extend(warnings);
        description.loops.push(described);
    }
    names::check_loops(description, errors);
}

/// Assigns parent and child links to joints.
pub(super) fn assemble(
    elements: Vec<InlineElement>,
    ident: &Ident,
    errors: &mut Errors,
) -> Description {
    let mut description = Description {
        name: Name {
            text: ident.to_string(),
            place: Place::Token(ident.span()),
        },
        source: Source::default(),
        links: Vec::new(),
        joints: Vec::new(),
        loops: Vec::new(),
        configurations: Vec::new(),
        collisions: Vec::new(),
        gravity: None,
        warnings: Vec::new(),
        unmodelled: Unmodelled::default(),
    };
    let mut waiting: Vec<InlineJoint> = Vec::new();
    let mut between: Vec<Link> = Vec::new();
    for element in elements {
        match element {
            InlineElement::Link(link) => {
                for mut joint in waiting.drain(..) {
                    joint.to.get_or_insert_with(|| link.name.clone());
                    description.joints.extend(joint.finish(errors));
                }
                description.links.push(link);
            }
            InlineElement::Joint(mut joint) => {
                let before = description.links.last().map(|link| link.name.clone());
                joint.from = joint.from.or(before);
                description.warnings.append(&mut joint.warnings);
                let own = joint.to.iter().filter(|_| joint.is_between);
                between.extend(own.map(|name| Link {
                    name: name.clone(),
                    inertial: None,
                }));
                waiting.push(joint);
            }
            InlineElement::Row(joint) => description.joints.push(joint),
        }
    }
    for joint in waiting {
        description.joints.extend(joint.finish(errors));
    }
    description.links.extend(between);
    names::check(&description, errors);
    description
}
