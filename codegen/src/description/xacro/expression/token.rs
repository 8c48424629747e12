//! Words of an expression.

use std::rc::Rc;

use super::value::{LARGEST_INTEGER, Value};
use crate::description::xacro::failure::{Failure, failure};
use crate::wording::quoted;

/// A word.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Integer(i64),
    Float(f64),
    Text(Rc<str>),
    /// A name or a keyword.
    Word(Rc<str>),
    /// An operator or a bracket.
    Sign(&'static str),
}

/// Operators and brackets; longer ones before their beginnings.
const SIGNS: [&str; 30] = [
    "**", "//", "<<", ">>", "<=", ">=", "==", "!=", ":=", "+", "-", "*", "/", "%", "(", ")", "[",
    "]", ",", ":", ".", "<", ">", "=", "~", "&", "|", "^", "@", "{",
];

/// Splits an expression into words.
pub(super) fn tokens(text: &str) -> Result<Vec<Token>, Failure> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let next = rest.chars().nth(1);
        let is_number = first.is_ascii_digit()
            || (first == '.' && next.is_some_and(|next| next.is_ascii_digit()));
        let length = if is_number {
            let length = number_length(rest);
            tokens.push(number(&rest[..length])?);
            length
        } else if let Some(prefix) = text_prefix(rest) {
            let (text, length) = string(rest, prefix)?;
            tokens.push(Token::Text(text.into()));
            length
        } else if first.is_alphabetic() || first == '_' {
            let ends = |letter: char| !letter.is_alphanumeric() && letter != '_';
            let length = rest.find(ends).unwrap_or(rest.len());
            tokens.push(Token::Word(rest[..length].into()));
            length
        } else {
            let sign = SIGNS.into_iter().find(|sign| rest.starts_with(sign));
            let sign =
                sign.ok_or_else(|| failure(format!("unexpected {}", quoted(&first.to_string()))))?;
            tokens.push(Token::Sign(sign));
            sign.len()
        };
        rest = rest[length..].trim_start();
    }
    Ok(tokens)
}

/// The length of a number and of the letters that follow it.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let while_in = |from: usize, is: fn(&u8) -> bool| {
        let rest = bytes.iter().skip(from);
        from + rest.take_while(|byte| is(byte)).count()
    };
    let digits = |from| while_in(from, |byte| byte.is_ascii_digit() || *byte == b'_');
    let mut at = digits(0);
    if bytes.get(at) == Some(&b'.') {
        at = digits(at + 1);
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(at + 1), Some(b'+' | b'-')));
        if bytes.get(at + 1 + sign).is_some_and(u8::is_ascii_digit) {
            at = digits(at + 1 + sign);
        }
    }
    while_in(at, |byte| byte.is_ascii_alphanumeric() || *byte == b'_')
}

fn number(word: &str) -> Result<Token, Failure> {
    let refused = || failure(format!("{} is not a number", quoted(word)));
    let lower = word.to_ascii_lowercase();
    // Underscores stand between digits.
    let is_between = |(at, _): (usize, _)| {
        let digit = |at: Option<usize>| {
            let byte = at.and_then(|at| lower.as_bytes().get(at));
            byte.is_some_and(u8::is_ascii_hexdigit)
        };
        digit(at.checked_sub(1)) && digit(Some(at + 1))
    };
    if !lower.match_indices('_').all(is_between) {
        return Err(refused());
    }
    let plain = lower.replace('_', "");
    let radix = |prefix, radix| {
        let digits = plain.strip_prefix(prefix)?;
        Some(i64::from_str_radix(digits, radix))
    };
    let other = radix("0x", 16).or(radix("0o", 8)).or(radix("0b", 2));
    if let Some(read) = other {
        let value = read.map_err(|_| refused())?;
        return integer(value);
    }
    if plain.bytes().all(|byte| byte.is_ascii_digit()) {
        if plain.starts_with('0') && plain.bytes().any(|byte| byte != b'0') {
            return Err(refused());
        }
        return integer(plain.parse().unwrap_or(i64::MAX));
    }
    let is_decimal = plain
        .bytes()
        .all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'e' | b'+' | b'-'));
    let value = plain.parse().ok().filter(|_| is_decimal);
    value.map(Token::Float).ok_or_else(refused)
}

fn integer(value: i64) -> Result<Token, Failure> {
    Value::integer(value.min(LARGEST_INTEGER + 1)).map(|_| Token::Integer(value))
}

/// The prefix of a text in quotes; `None` if no text begins here.
fn text_prefix(text: &str) -> Option<&str> {
    // No prefix is longer than a letter.
    let mut first = text.char_indices().take(2);
    let (quote, _) = first.find(|(_, letter)| matches!(letter, '\'' | '"'))?;
    let prefix = &text[..quote];
    ["", "r", "R", "u", "U", "f", "F", "b", "B"]
        .contains(&prefix)
        .then_some(prefix)
}

/// The text in quotes at the beginning, and its length with quotes.
fn string(text: &str, prefix: &str) -> Result<(String, usize), Failure> {
    if prefix.eq_ignore_ascii_case("f") || prefix.eq_ignore_ascii_case("b") {
        return Err(failure(format!(
            "texts with the prefix {prefix} are not supported"
        )));
    }
    let is_raw = prefix.eq_ignore_ascii_case("r");
    let body = &text[prefix.len()..];
    let single = &body[..1];
    let triple = single.repeat(3);
    let quote = if body.starts_with(&triple) {
        &triple
    } else {
        single
    };
    let mut out = String::new();
    let mut at = quote.len();
    loop {
        let rest = &body[at..];
        if rest.starts_with(quote) {
            return Ok((out, prefix.len() + at + quote.len()));
        }
        let Some(letter) = rest.chars().next() else {
            return Err(failure("a text in quotes does not end"));
        };
        if letter == '\\' {
            let (escaped, length) = escape(rest)?;
            if is_raw {
                out.push_str(&rest[..length]);
            } else {
                out.push_str(&escaped);
            }
            at += length;
        } else {
            out.push(letter);
            at += letter.len_utf8();
        }
    }
}

/// The character of an escape, and the escape's length.
fn escape(text: &str) -> Result<(String, usize), Failure> {
    let letter = text.chars().nth(1);
    let code = |digits: usize| {
        let code = text.get(2..2 + digits);
        let code = code.and_then(|code| u32::from_str_radix(code, 16).ok());
        let letter = code.and_then(char::from_u32);
        letter
            .map(|letter| (letter.to_string(), 2 + digits))
            .ok_or_else(|| failure("an escape in a text is not complete"))
    };
    let one = |letter: char| Ok((letter.to_string(), 2));
    match letter {
        None => Err(failure("a text in quotes does not end")),
        Some('n') => one('\n'),
        Some('t') => one('\t'),
        Some('r') => one('\r'),
        Some('0') => one('\0'),
        Some(letter @ ('\\' | '\'' | '"')) => one(letter),
        Some('x') => code(2),
        Some('u') => code(4),
        Some('U') => code(8),
        // Python keeps other backslashes.
        Some(other) => Ok((format!("\\{other}"), 1 + other.len_utf8())),
    }
}
