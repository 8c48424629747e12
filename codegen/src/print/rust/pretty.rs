//! Tokens as a person reads them.
//!
//! In: a [`TokenStream`] of items. Out: a [`Source`] whose `Display` is formatted Rust. It never
//! changes a token.

use std::fmt;

use proc_macro2::TokenStream;

/// Formatted source text, with line comments above it.
#[derive(Clone, Debug)]
pub struct Source {
    header: String,
    text: String,
}

impl Source {
    /// Formats items under a header of whole lines, which may be empty.
    #[must_use]
    pub fn new(header: impl Into<String>, items: &TokenStream) -> Self {
        let text = match syn::parse2::<syn::File>(items.clone()) {
            Ok(file) => spaced(&prettyplease::unparse(&file)),
            // What is no file of Rust is still worth reading.
            Err(_) => items.to_string(),
        };
        Self {
            header: header.into(),
            text,
        }
    }
}

impl fmt::Display for Source {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.header.is_empty() {
            writeln!(out, "{}", self.header)?;
        }
        out.write_str(&self.text)
    }
}

/// The same with an empty line after every item and method, as people write it.
fn spaced(text: &str) -> String {
    let mut spaced = String::with_capacity(text.len());
    let mut after_item = false;
    for line in text.lines() {
        let closes = line.trim_start() == "}";
        if after_item && !closes && !line.is_empty() {
            spaced.push('\n');
        }
        spaced.push_str(line);
        spaced.push('\n');
        // Deeper braces belong to expressions.
        after_item =
            matches!(line, "}" | "    }") || (line.ends_with(';') && !line.starts_with(' '));
    }
    spaced
}
