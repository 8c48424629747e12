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
mod contents;
pub(super) mod joint;
pub(super) mod table;
pub(super) mod text;

use std::path::Path;

use proc_macro2::TokenStream;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Generics, Ident, Token, Visibility, token};

pub(super) use self::contents::{Contents, entries};
use self::contents::{add, assemble};
use super::item::Item;
use super::tokens::{self, Parsed, diagnostic, diagnostic_with_hint};
use super::{Description, Given, file};
use crate::error::{Errors, Place};

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

/// The item, with the description read from the named file or assembled from its parts.
pub(super) fn item(contents: Contents, ident: Ident, folder: &Path, errors: &mut Errors) -> Item {
    let Contents {
        settings,
        elements,
        loops,
    } = contents;
    let place = Place::Token(ident.span());
    if let Some(extra) = settings.files.get(usize::from(elements.is_empty())) {
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
        None if elements.is_empty() => {
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
        None => Some(assemble(elements, &ident, errors)),
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

#[cfg(test)]
mod tests;
