//! Front end for the macros `#[derive(Robot)]` and `chain!`.
//!
//! The tokens become the generated code. If there are errors, they become each error at the word that caused it, with
//! stubs that keep the rest of the program compiling.

mod kept;

use std::path::{Path, PathBuf};

use proc_macro2::{Ident, Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::ext::IdentExt;

use crate::description::{Description, HOW_TO_ASK, Item, attributes, inline};
use crate::error::{Errors, Place};
use crate::expand::{expand, settled, understand};
use crate::function::Function;
use crate::module::About;
use crate::print::rust::{self, Declaration, Library};
use crate::space::Spaces;
use crate::{chain, request};
use kept::{CacheEntry, Expansion};

pub use kept::Kept;

/// Expands `#[derive(Robot)]`, unless the expansion has been kept.
#[must_use]
pub fn derive(tokens: TokenStream, kept: Option<&Kept>) -> TokenStream {
    let mut errors = Errors::new();
    let kept = kept.and_then(|kept| kept.entry("derive", &tokens));
    match attributes::read(tokens, &folder(), &mut errors) {
        Some(item) => open(&item, errors, kept, |_| Declaration::Exists),
        None => errors.to_compile_errors(),
    }
}

/// Expands `chain!`, unless the expansion has been kept.
#[must_use]
pub fn chain(tokens: TokenStream, kept: Option<&Kept>) -> TokenStream {
    let mut errors = Errors::new();
    let kept = kept.and_then(|kept| kept.entry("chain", &tokens));
    match inline::read(tokens, &folder(), &mut errors) {
        Some(item) => open(&item, errors, kept, |item| {
            Declaration::Written(declaration(item))
        }),
        None => errors.to_compile_errors(),
    }
}

/// The folder that relative paths in macros begin at: that of the user's `Cargo.toml`.
fn folder() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR")
        .map(PathBuf::from)
        .unwrap_or_default()
}

fn open(
    item: &Item,
    mut errors: Errors,
    kept: Option<CacheEntry<'_>>,
    declare: fn(&Item) -> Declaration,
) -> TokenStream {
    let target = rust::Item {
        visibility: item.visibility.clone(),
        ident: item.ident.clone(),
        generics: item.generics.clone(),
        declaration: declare(item),
    };
    // After an error in the description, even the number of joints is uncertain, so the stubs accept any number.
    let read = item.description.as_ref().filter(|_| errors.is_empty());
    if let Some(description) = read.filter(|_| !item.names_functions) {
        let ident = &item.ident;
        let message = format!("{ident} does not name the functions to generate");
        errors.push_with_hint(Place::Token(ident.span()), message, HOW_TO_ASK);
        if let Err(mistakes) = understand(description, &item.request) {
            errors.append(mistakes);
        }
    } else if let Some(description) = read {
        let kept = kept.map(|entry| entry.of(&description.source));
        let expansion = match kept.as_ref().and_then(CacheEntry::find) {
            Some(found) => Ok(found),
            None => expand(description, &item.request).map(|module| {
                let library = Library::runtime(item.request.runtime.as_ref());
                let expansion = Expansion {
                    robot: rust::print(&module, &target, &library),
                    warnings: texts(&module.about),
                };
                if let Some(entry) = kept {
                    entry.keep(&expansion);
                }
                expansion
            }),
        };
        match expansion {
            Ok(Expansion { robot, warnings }) => {
                let file = item.file.as_ref().map(|file| folder().join(file.value()));
                let beside = description.source.beside.iter();
                let watched = file.iter().chain(beside).map(|path| watch(path));
                let watch: TokenStream = watched.collect();
                let warnings = all_warnings(warnings, item);
                return quote! { #robot #watch #warnings };
            }
            Err(mistakes) => errors.append(mistakes),
        }
    }
    let mistakes = errors.to_compile_errors();
    let spaces = read.and_then(|robot| spaces(robot, &item.request));
    let stub = rust::stub(&target, &item.request, spaces.as_ref());
    quote! { #mistakes #stub }
}

/// Makes the compiler expand again when a file changes.
fn watch(path: &Path) -> TokenStream {
    let path = path.to_string_lossy();
    quote! { const _: &[::core::primitive::u8] = ::core::include_bytes!(#path); }
}

/// The warnings about a robot, each with its hint.
fn texts(about: &About) -> Vec<String> {
    let warnings = about.located_warnings().into_iter().zip(&about.warnings);
    let warnings = warnings.map(|(text, warning)| {
        let hint = warning.hint.as_ref().map(|hint| format!(": {hint}"));
        text + &hint.unwrap_or_default()
    });
    warnings.collect()
}

/// Warnings about a robot and its struct for the compiler, each with the key that silences it.
fn all_warnings(about_robot: Vec<String>, item: &Item) -> TokenStream {
    if item.request.quiet {
        return TokenStream::new();
    }
    let warnings = about_robot
        .into_iter()
        .map(|text| (text, item.ident.span()));
    let forgotten = forgotten_fields(item).map(|field| {
        let text = format!(
            "field `{field}` has no attribute and changes nothing: write #[robot(mass_of = \"link\")] above it, or rename it"
        );
        (text, field.span())
    });
    let warnings = warnings
        .chain(forgotten)
        .map(|(text, at)| warning(&format!("{text}; the key `quiet` silences warnings"), at));
    warnings.collect()
}

/// Fields without an attribute that are probably meant as parameters: beside fields with an attribute, and named
/// `payload` or like a link or a joint.
fn forgotten_fields(item: &Item) -> impl Iterator<Item = &Ident> {
    let plain = |name: &str| {
        name.replace(|letter: char| !letter.is_alphanumeric(), "_")
            .to_lowercase()
    };
    let description = item.description.iter();
    let names = description.flat_map(|robot| {
        let links = robot.links.iter().map(|link| &link.name);
        links.chain(robot.joints.iter().map(|joint| &joint.name))
    });
    let mut names: Vec<String> = names.map(|name| plain(&name.text)).collect();
    names.push("payload".to_owned());
    let is_beside_others = !item.request.parameters.is_empty();
    let fields = item.own_fields.iter();
    fields
        .filter(move |field| is_beside_others && names.contains(&plain(&field.unraw().to_string())))
}

/// A warning of the compiler. On stable Rust a macro can only cause the warning of a deprecated item, whose note is any
/// text, and only at a token of the user's.
fn warning(text: &str, at: Span) -> TokenStream {
    quote_spanned! {at=>
        const _: () = {
            #[deprecated(note = #text)]
            const ROBOT: () = ();
            ROBOT
        };
    }
}

/// The joints and coordinates of a robot, if the description is valid with the part of the request that decides them.
fn spaces(description: &Description, request: &request::Request) -> Option<Spaces> {
    let shape = request::Request {
        base: request.base.clone(),
        floating: request.floating,
        lock: request.lock.clone(),
        drop: request.drop.clone(),
        path_only: request.path_only,
        tip: request.tip.clone().filter(|_| request.path_only),
        ..request::Request::default()
    };
    let chain = settled(chain::build(description, &shape).ok()?, false).ok()?;
    let chain = if request.asks_for(Function::BaseRegressor) {
        chain.identified()
    } else {
        chain
    };
    Some(chain.spaces().clone())
}

fn declaration(item: &Item) -> TokenStream {
    let Item {
        attributes,
        visibility,
        ident,
        ..
    } = item;
    quote! {
        #(#attributes)*
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        #visibility struct #ident;
    }
}
