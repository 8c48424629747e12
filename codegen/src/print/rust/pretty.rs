//! Formatting of tokens.
//!
//! In: a [`TokenStream`] of items. Out: a [`FormattedSource`] whose `Display` is formatted Rust.

use std::fmt;

use proc_macro2::TokenStream;
use quote::ToTokens;

use crate::print::ascii::spelt;

/// Formatted source text, with line comments at its head.
#[derive(Clone, Debug)]
pub struct FormattedSource {
    header: String,
    text: String,
    appendix: String,
}

impl FormattedSource {
    /// Formats items under a header of whole lines, which may be empty.
    #[must_use]
    pub fn new(header: impl Into<String>, items: &TokenStream) -> Self {
        let text = match syn::parse2::<syn::File>(items.clone()) {
            Ok(file) => spaced(&prettyplease::unparse(&file)),
            // Tokens that do not parse are shown as they are.
            Err(_) => items.to_string(),
        };
        Self {
            header: header.into(),
            text,
            appendix: String::new(),
        }
    }

    /// A file: items with `#[rustfmt::skip]`, since versions of rustfmt lay out long lists differently, and text after
    /// them.
    #[must_use]
    pub fn file(header: impl Into<String>, items: &TokenStream, appendix: String) -> Self {
        let mut file: syn::File = match syn::parse2(items.clone()) {
            Ok(file) => file,
            Err(_) => return Self::new(header, items),
        };
        for item in &mut file.items {
            let attributes = match item {
                syn::Item::Fn(item) => &mut item.attrs,
                syn::Item::Impl(item) => &mut item.attrs,
                syn::Item::Struct(item) => &mut item.attrs,
                _ => continue,
            };
            attributes.push(syn::parse_quote! { #[rustfmt::skip] });
        }
        Self {
            appendix,
            ..Self::new(header, &file.into_token_stream())
        }
    }

    /// The same in ASCII.
    #[must_use]
    pub(crate) fn in_ascii(self) -> Self {
        let [header, text, appendix] =
            [self.header, self.text, self.appendix].map(|text| spelt(&text));
        Self {
            header,
            text,
            appendix,
        }
    }
}

impl fmt::Display for FormattedSource {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.header.is_empty() {
            writeln!(out, "{}", self.header)?;
        }
        out.write_str(&self.text)?;
        out.write_str(&self.appendix)
    }
}

/// The same with an empty line after every item and method.
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
