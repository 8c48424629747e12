//! Reads names, numbers, vectors and lists from tokens, each with its place.
//!
//! An error is reported under the wrong token. The caller then continues behind the next separator, so that all errors
//! of a macro call are reported at once.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseBuffer, ParseStream};
use syn::{Ident, LitFloat, LitInt, LitStr, Token, token};

use super::{Name, Number, constant};
use crate::error::{Diagnostic, Errors, Place};
use crate::wording::{known, quoted};

/// A parsed value, or an error.
pub(super) type Parsed<T> = Result<T, Diagnostic>;

impl From<syn::Error> for Diagnostic {
    fn from(error: syn::Error) -> Self {
        diagnostic(error.span(), error.to_string())
    }
}

pub(super) fn diagnostic(span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic {
        place: Place::Token(span),
        message: message.into(),
        hint: None,
    }
}

pub(super) fn diagnostic_with_hint(
    span: Span,
    message: impl Into<String>,
    hint: impl Into<String>,
) -> Diagnostic {
    Diagnostic {
        hint: Some(hint.into()),
        ..diagnostic(span, message)
    }
}

/// Adds an error to the list.
pub(super) fn push(errors: &mut Errors, diagnostic: Diagnostic) {
    match diagnostic.hint {
        Some(hint) => errors.push_with_hint(diagnostic.place, diagnostic.message, hint),
        None => errors.push(diagnostic.place, diagnostic.message),
    }
}

/// Maximum nesting of brackets; deeper ones would overflow the stack of Rust's parsers.
const DEEPEST: usize = 128;

/// Rejects brackets that are nested too deep.
pub(super) fn check_depth(tokens: &TokenStream) -> Parsed<()> {
    // Without recursion, which could overflow itself.
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(innermost) = open.last_mut() {
        match innermost.next() {
            Some(TokenTree::Group(group)) if open.len() > DEEPEST => {
                let message = format!("brackets are nested more than {DEEPEST} deep");
                return Err(diagnostic(group.span_open(), message));
            }
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
            Some(_) => {}
            None => drop(open.pop()),
        }
    }
    Ok(())
}

/// A word, including keywords of Rust.
pub(super) fn word(input: ParseStream) -> Parsed<Ident> {
    if input.peek(LitStr) {
        let literal: LitStr = input.parse()?;
        let text = literal.value();
        let message = format!("expected a word, not the string {}", quoted(&text));
        // The hint fits only if the string is an identifier.
        return Err(match syn::parse_str::<Ident>(&text) {
            Ok(word) => {
                let hint = format!("write {word}, without quotes");
                diagnostic_with_hint(literal.span(), message, hint)
            }
            Err(_) => diagnostic(literal.span(), message),
        });
    }
    Ok(input.call(Ident::parse_any)?.unraw())
}

/// A name: a word, or a string for a name that is not an identifier.
pub(super) fn name(input: ParseStream) -> Parsed<Name> {
    let (text, span) = if input.peek(LitStr) {
        let literal: LitStr = input.parse()?;
        (literal.value(), literal.span())
    } else if input.peek(Ident::peek_any) {
        let word = word(input)?;
        (word.to_string(), word.span())
    } else {
        return Err(diagnostic(input.span(), "expected a name"));
    };
    if text.trim().is_empty() {
        return Err(diagnostic(span, "this name is empty"));
    }
    Ok(Name {
        text,
        place: Place::Token(span),
    })
}

/// The `=` or `:` between a key and its value.
pub(super) fn separator(input: ParseStream, key: &Ident) -> Parsed<()> {
    if input.peek(Token![=]) {
        input.parse::<Token![=]>()?;
    } else if input.peek(Token![:]) {
        input.parse::<Token![:]>()?;
    } else {
        let message = format!("expected `=` or `:` after `{key}`");
        // If the key is the last word, there is no token after it to point at.
        let span = if input.is_empty() {
            key.span()
        } else {
            input.span()
        };
        return Err(diagnostic(span, message));
    }
    Ok(())
}

/// A number: a literal, `pi`, or a product or quotient of such.
pub(super) fn number(input: ParseStream, subject: &str) -> Parsed<Number> {
    let span = input.span();
    let mut text = String::new();
    if input.peek(Token![-]) {
        input.parse::<Token![-]>()?;
        text.push('-');
    }
    loop {
        text.push_str(&factor(input, subject)?);
        if input.peek(Token![*]) {
            input.parse::<Token![*]>()?;
            text.push('*');
        } else if input.peek(Token![/]) {
            input.parse::<Token![/]>()?;
            text.push('/');
        } else {
            break;
        }
    }
    constant::read(&text, Place::Token(span)).map_err(|refusal| Diagnostic {
        place: Place::Token(span),
        message: format!("{subject} {}", refusal.what),
        hint: refusal.hint.map(str::to_owned),
    })
}

fn factor(input: ParseStream, subject: &str) -> Parsed<String> {
    let (digits, suffix, span) = if input.peek(LitFloat) {
        let literal: LitFloat = input.parse()?;
        let digits = literal.base10_digits().to_owned();
        (digits, literal.suffix().to_owned(), literal.span())
    } else if input.peek(LitInt) {
        let literal: LitInt = input.parse()?;
        let digits = literal.base10_digits().to_owned();
        (digits, literal.suffix().to_owned(), literal.span())
    } else if input.peek(Ident) && input.fork().parse::<Ident>()? == "pi" {
        input.parse::<Ident>()?;
        return Ok("pi".to_owned());
    } else {
        let message = format!("{subject} is not a number");
        let hint = "write digits, or pi: 0.5, -1e-3, pi/2";
        return Err(diagnostic_with_hint(input.span(), message, hint));
    };
    if suffix.is_empty() {
        Ok(digits)
    } else {
        let message = format!("{subject} has the suffix {}", quoted(&suffix));
        Err(diagnostic_with_hint(span, message, "leave it out"))
    }
}

/// A list of numbers in brackets.
pub(super) fn numbers(input: ParseStream, subject: &str) -> Parsed<(Span, Vec<Number>)> {
    let span = input.span();
    if !input.peek(token::Bracket) {
        let message = format!("{subject} is not a list of numbers");
        return Err(diagnostic_with_hint(span, message, "write [0.0, 0.0, 1.0]"));
    }
    let content = brackets(input)?;
    Ok((span, list(&content, |input| number(input, subject))?))
}

/// A number, or a list of numbers in brackets.
pub(super) fn one_or_more(input: ParseStream, subject: &str) -> Parsed<Vec<Number>> {
    if !input.peek(token::Bracket) {
        return Ok(vec![number(input, subject)?]);
    }
    let (span, numbers) = numbers(input, subject)?;
    if numbers.is_empty() {
        return Err(diagnostic(span, format!("{subject} is an empty list")));
    }
    Ok(numbers)
}

/// Exactly `N` numbers in brackets.
pub(super) fn vector<const N: usize>(input: ParseStream, subject: &str) -> Parsed<[Number; N]> {
    let (span, numbers) = numbers(input, subject)?;
    exactly(numbers, span, subject)
}

/// Exactly `N` numbers in parentheses.
pub(super) fn arguments<const N: usize>(input: ParseStream, subject: &str) -> Parsed<[Number; N]> {
    let span = input.span();
    let content = parentheses(input)?;
    exactly(
        list(&content, |input| number(input, subject))?,
        span,
        subject,
    )
}

fn exactly<const N: usize>(numbers: Vec<Number>, span: Span, subject: &str) -> Parsed<[Number; N]> {
    <[Number; N]>::try_from(numbers).map_err(|numbers| {
        let count = numbers.len();
        let plural = if count == 1 { "" } else { "s" };
        diagnostic(
            span,
            format!("{subject} has {count} number{plural} instead of {N}"),
        )
    })
}

/// The content of parentheses.
pub(super) fn parentheses(input: ParseStream<'_>) -> syn::Result<ParseBuffer<'_>> {
    let content;
    syn::parenthesized!(content in input);
    Ok(content)
}

/// The content of braces.
pub(super) fn braces(input: ParseStream<'_>) -> syn::Result<ParseBuffer<'_>> {
    let content;
    syn::braced!(content in input);
    Ok(content)
}

fn brackets(input: ParseStream<'_>) -> syn::Result<ParseBuffer<'_>> {
    let content;
    syn::bracketed!(content in input);
    Ok(content)
}

/// Elements separated by commas.
pub(super) fn list<T>(
    input: ParseStream,
    mut element: impl FnMut(ParseStream) -> Parsed<T>,
) -> Parsed<Vec<T>> {
    let mut elements = Vec::new();
    while !input.is_empty() {
        elements.push(element(input)?);
        if !input.is_empty() {
            input.parse::<Token![,]>()?;
        }
    }
    Ok(elements)
}

/// The fields of `{ key: value, … }`, if there are braces; `field` reads the value of a key. Unknown and repeated keys
/// are errors, and reading continues with the next field.
pub(super) fn fields(
    input: ParseStream,
    subject: &str,
    keys: &[&str],
    errors: &mut Errors,
    mut field: impl FnMut(&str, ParseStream) -> Parsed<()>,
) -> Parsed<()> {
    if !input.peek(token::Brace) {
        return Ok(());
    }
    let content = braces(input)?;
    let mut seen: Vec<Ident> = Vec::new();
    while !content.is_empty() {
        let mut read = || {
            let key = word(&content)?;
            let text = key.to_string();
            if !keys.contains(&text.as_str()) {
                let message = format!("{subject} has the unknown key {}", quoted(&text));
                let hint = known(&text, "keys", keys);
                return Err(diagnostic_with_hint(key.span(), message, hint));
            }
            if seen.contains(&key) {
                let message = format!("{subject} has the key {} twice", quoted(&text));
                return Err(diagnostic(key.span(), message));
            }
            seen.push(key.clone());
            separator(&content, &key)?;
            field(&text, &content)
        };
        if let Err(diagnostic) = read() {
            push(errors, diagnostic);
        } else if content.peek(Ident::peek_any) {
            // Only the comma is missing, so the next field can be read.
            let message = "expected `,` between two fields";
            push(errors, diagnostic(content.span(), message));
            continue;
        } else if !content.is_empty() && !content.peek(Token![,]) {
            push(errors, diagnostic(content.span(), "expected `,`"));
        }
        skip(&content, |token| is_punctuation(token, ','));
    }
    Ok(())
}

/// Skips tokens up to and including the first that fulfils `last`.
pub(super) fn skip(input: ParseStream, last: impl Fn(&TokenTree) -> bool) {
    while let Ok(token) = input.parse::<TokenTree>() {
        if last(&token) {
            break;
        }
    }
}

pub(super) fn is_punctuation(token: &TokenTree, character: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == character)
}

pub(super) fn is_braces(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
}

/// Messages with lines and columns of tokens, for the tests of the grammar.
#[cfg(test)]
pub(super) fn show(errors: &Errors) -> String {
    let line = |diagnostic: &Diagnostic| {
        let place = match diagnostic.place {
            Place::Token(span) => {
                let start = span.start();
                format!("{}:{}: ", start.line, start.column + 1)
            }
            _ => String::new(),
        };
        let hint = diagnostic.hint.as_ref();
        let hint = hint.map_or(String::new(), |hint| format!("\n  hint: {hint}"));
        format!("{place}{}{hint}\n", errors.locate(diagnostic))
    };
    let lines: Vec<String> = errors.diagnostics().iter().map(line).collect();
    lines.concat()
}
