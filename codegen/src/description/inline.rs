//! The grammar of `chain!`, which is also that of `#[robot(…)]`: settings, links, joints and loops.
//!
//! A joint without `from` has the link before it as its parent, one without `to` has the link after it as its child, so
//! that a serial arm is written from base to end effector. A loop, which may also be added to a file, joins two links
//! of the tree. After an error, reading continues behind the next `,`, `;` or `}`.
//!
//! ```text
//! pub struct Scara { gravity: [0.0, 0.0, -9.81], generate(inverse_dynamics) }
//! link base;
//! joint shoulder: revolute(z) { at: xyz(0.0, 0.0, 0.4), limits: [-2.9, 2.9] }
//! link upper { mass: 3.2, com: [0.12, 0.0, 0.0], inertia: [0.01, 0.02, 0.02] }
//! ```

pub(super) mod body;
pub(super) mod closure;
pub(super) mod composite;
pub(super) mod joint;
pub(super) mod table;
pub(super) mod text;

use std::path::Path;

use proc_macro2::TokenStream;
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Generics, Ident, Token, Visibility, token};

use self::joint::Joint;
use super::item::Item;
use super::settings::{self, Settings};
use super::tokens::{self, Parsed, diagnostic, diagnostic_with_hint};
use super::xacro::Given;
use super::{Description, Link, Loop, Name, Source, Unmodelled, file, names};
use crate::error::{Diagnostic, Errors, Place};
use crate::wording::quoted;

/// The entries between the braces or the parentheses.
#[derive(Default)]
pub(super) struct Contents {
    pub(super) settings: Settings,
    parts: Vec<Part>,
    /// Loops, each with its warnings.
    loops: Vec<(Loop, Vec<Diagnostic>)>,
}

/// A part of the robot, in the order of the text.
enum Part {
    Link(Link),
    Joint(Joint),
    /// A row of a table: a joint whose links are known.
    Row(super::Joint),
}

/// Reads the tokens of `chain!`; paths of files are relative to `folder`.
///
/// `None` if no struct is named.
pub fn read(tokens: TokenStream, folder: &Path, errors: &mut Errors) -> Option<Item> {
    if let Err(diagnostic) = tokens::check_depth(&tokens) {
        tokens::push(errors, diagnostic);
        return None;
    }
    let mut found = None;
    let parser = |input: ParseStream| {
        found = chain(input, folder, errors)
            .map_err(|diagnostic| tokens::push(errors, diagnostic))
            .ok();
        tokens::skip(input, |_| false);
        Ok(())
    };
    // Errors were reported where they were found.
    let _ = parser.parse2(tokens);
    found
}

fn chain(input: ParseStream, folder: &Path, errors: &mut Errors) -> Parsed<Item> {
    let attributes = input.call(Attribute::parse_outer)?;
    let visibility: Visibility = input.parse()?;
    if !input.peek(Token![struct]) {
        let hint = "a chain begins with the struct it makes: struct Arm;";
        return Err(diagnostic_with_hint(
            input.span(),
            "expected `struct`",
            hint,
        ));
    }
    input.parse::<Token![struct]>()?;
    let ident: Ident = input.parse()?;
    let mut contents = Contents::default();
    if input.peek(token::Brace) {
        let braces = tokens::braces(input)?;
        entries(&braces, &mut contents, errors);
    } else if input.peek(Token![;]) {
        input.parse::<Token![;]>()?;
    } else {
        let message = format!("expected `{{` or `;` after `{ident}`");
        tokens::push(errors, diagnostic(input.span(), message));
        tokens::skip(input, |token| {
            tokens::is_braces(token) || tokens::is_punctuation(token, ';')
        });
    }
    entries(input, &mut contents, errors);
    let mut item = item(contents, ident, folder, errors);
    item.attributes = attributes;
    item.visibility = visibility;
    Ok(item)
}

/// Reads settings, links, joints and loops up to the end.
pub(super) fn entries(input: ParseStream, contents: &mut Contents, errors: &mut Errors) {
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
            contents.parts.push(Part::Link(link(input, errors)?));
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
                contents.parts.push(Part::Joint(joint));
            }
        }
        "loop" if !is_setting => {
            tokens::word(input)?;
            contents.loops.extend(closure::read(input, errors)?);
        }
        "denavit_hartenberg" if !is_setting => {
            let word = tokens::word(input)?;
            let (links, joints) = table::read(input, word.span(), errors)?;
            contents.parts.extend(links.into_iter().map(Part::Link));
            contents.parts.extend(joints.into_iter().map(Part::Row));
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

/// The item, with the description read from the named file or assembled from its parts.
pub(super) fn item(contents: Contents, ident: Ident, folder: &Path, errors: &mut Errors) -> Item {
    let Contents {
        settings,
        parts,
        loops,
    } = contents;
    let place = Place::Token(ident.span());
    if let Some(extra) = settings.files.get(usize::from(parts.is_empty())) {
        let message = format!("{ident} is described twice");
        let hint = "name one file, or describe links and joints in place";
        tokens::push(errors, diagnostic_with_hint(extra.span(), message, hint));
    }
    let file = settings.files.first().cloned();
    let mut description = match &file {
        Some(path) => {
            let given = Given::of(&settings.request, folder);
            let file = folder.join(path.value());
            file::read_file_with(&file, &given, Some(path.span()), errors)
        }
        None if parts.is_empty() => {
            // The description may be among the parts that could not be read.
            if errors.is_empty() {
                errors.push_with_hint(
                    place,
                    format!("{ident} has no description"),
                    "name a file, urdf = \"arm.urdf\", or describe links and joints",
                );
            }
            None
        }
        None => Some(assemble(parts, &ident, errors)),
    };
    if let Some(description) = &mut description {
        add(description, loops, errors);
    }
    Item {
        attributes: Vec::new(),
        visibility: Visibility::Inherited,
        ident,
        generics: Generics::default(),
        file,
        description,
        names_functions: settings.span("generate").is_some(),
        own_fields: Vec::new(),
        request: settings.request,
    }
}

/// Adds loops to a description, each written as after the word `loop`.
pub fn close<'t>(
    description: &mut Description,
    texts: impl IntoIterator<Item = &'t str>,
    errors: &mut Errors,
) {
    let loops = texts.into_iter();
    let loops = loops.filter_map(|text| closure::read_text(text, errors));
    let loops = loops.collect();
    add(description, loops, errors);
}

/// Adds loops and their warnings to those of the file.
fn add(description: &mut Description, loops: Vec<(Loop, Vec<Diagnostic>)>, errors: &mut Errors) {
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
fn assemble(parts: Vec<Part>, ident: &Ident, errors: &mut Errors) -> Description {
    let mut description = Description {
        name: Name {
            text: ident.to_string(),
            place: Place::Token(ident.span()),
        },
        source: Source::default(),
        links: Vec::new(),
        joints: Vec::new(),
        loops: Vec::new(),
        gravity: None,
        warnings: Vec::new(),
        unmodelled: Unmodelled::default(),
    };
    let mut waiting: Vec<Joint> = Vec::new();
    let mut between: Vec<Link> = Vec::new();
    for part in parts {
        match part {
            Part::Link(link) => {
                for mut joint in waiting.drain(..) {
                    joint.to.get_or_insert_with(|| link.name.clone());
                    description.joints.extend(joint.finish(errors));
                }
                description.links.push(link);
            }
            Part::Joint(mut joint) => {
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
            Part::Row(joint) => description.joints.push(joint),
        }
    }
    for joint in waiting {
        description.joints.extend(joint.finish(errors));
    }
    description.links.extend(between);
    names::check(&description, errors);
    description
}

#[cfg(test)]
mod tests;
