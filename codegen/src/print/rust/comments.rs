//! Comments above Rust.
//!
//! In: lines of [`documentation`]. Out: doc comments, and the head of a file, with what the code needs to be compiled.

use std::fmt::Write;

use proc_macro2::TokenStream;
use quote::quote;

use super::library::{Library, spelled};
use super::names;
use crate::module::Module;
use crate::print::documentation;
use crate::wording::{code, visible};

/// Doc comment of these lines.
pub(super) fn doc(lines: &[impl AsRef<str>]) -> TokenStream {
    let lines = lines.iter().map(|line| match &*visible(line.as_ref()) {
        "" => String::new(),
        line => format!(" {line}"),
    });
    quote! { #(#[doc = #lines])* }
}

/// Head of a generated file as line comments: origin, request, requirements, costs.
#[must_use]
pub fn header(module: &Module, asked: &str, library: &Library) -> String {
    let mut lines = documentation::head(module, asked);
    lines.push(needs(library));
    for (generated, name) in module.functions.iter().zip(names::of_methods(module)) {
        lines.extend(documentation::operation_count(generated, &name.to_string()));
    }
    lines.iter().fold(String::new(), |mut text, line| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "// {}", visible(line));
        text
    })
}

/// Minimum Rust version of a file for `core` alone, without and with functions for C.
const COMPILERS: [&str; 2] = ["1.63", "1.82"];

/// Edition that the paths in files need.
const EDITION: &str = "edition 2018 or later";

/// Requirements of a file for compilation.
fn needs(library: &Library) -> String {
    match library {
        Library::Runtime(path) => {
            let own = env!("CARGO_PKG_RUST_VERSION");
            format!(
                "Needs: Rust {own} or later, {EDITION}, {}.",
                code(&spelled(path))
            )
        }
        Library::Lanes(path) => format!("Needs: {}.", code(&spelled(path))),
        Library::Core(core_functions) => {
            let oldest = COMPILERS[usize::from(core_functions.c_prefix.is_some())];
            let path = core_functions.sin_cos.as_ref();
            let path = path.map_or_else(String::new, |path| format!(", {}", code(&spelled(path))));
            format!("Needs: Rust {oldest} or later, {EDITION}, `core`{path}.")
        }
    }
}
