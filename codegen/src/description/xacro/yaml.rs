//! The part of YAML 1.1 that parameters of robots use.
//!
//! In: the text of a file. Out: a [`Value`] with the types of PyYAML. Block and flow mappings and sequences, scalars in
//! one line, comments, anchors, merged mappings (`<<: *base`) and the units of xacro (`!degrees 90`) are read. Other tags,
//! scalars of several lines and several documents are errors.

use std::collections::HashMap;

use super::expression::value::{Map, Value};
use super::failure::{Failure, failure, failure_with_hint};
use crate::wording::{known, quoted};

/// Maximum depth of mappings and sequences.
const MOST_NESTED: usize = 30;

/// Units of xacro, and their factors to rad and m.
const UNITS: [(&str, f64); 6] = [
    ("!radians", 1.0),
    ("!degrees", std::f64::consts::PI / 180.0),
    ("!meters", 1.0),
    ("!millimeters", 0.001),
    ("!foot", 0.3048),
    ("!inches", 0.0254),
];

/// Evaluates the expression of a number with a unit.
type Evaluate<'e> = &'e mut dyn FnMut(&str) -> Result<Value, Failure>;

/// Reads a text. An error has its line.
pub(super) fn read(text: &str, evaluate: Evaluate<'_>) -> Result<Value, (usize, Failure)> {
    let mut reader = YamlReader {
        lines: Vec::new(),
        at: 0,
        evaluate,
        depth: 0,
        anchors: HashMap::new(),
    };
    reader.split(text)?;
    if reader.lines.is_empty() {
        return Ok(Value::None);
    }
    let indent = reader.lines[0].indent;
    let value = reader.block(indent)?;
    match reader.lines.get(reader.at) {
        None => Ok(value),
        Some(line) => Err((line.number, failure("the indentation fits no line above"))),
    }
}

/// A line without its comment.
struct Line<'t> {
    number: usize,
    indent: usize,
    text: &'t str,
}

struct YamlReader<'t, 'e> {
    lines: Vec<Line<'t>>,
    at: usize,
    evaluate: Evaluate<'e>,
    depth: usize,
    /// The values of anchors, which copies share.
    anchors: HashMap<String, Value>,
}

type YamlResult<T> = Result<T, (usize, Failure)>;

impl<'t> YamlReader<'t, '_> {
    /// Splits a text into lines with content.
    fn split(&mut self, text: &'t str) -> YamlResult<()> {
        for (number, line) in text.lines().enumerate() {
            let number = number + 1;
            let content = without_comment(line).trim_end();
            let indent = content.len() - content.trim_start_matches(' ').len();
            let content = &content[indent..];
            if content.is_empty() || content.starts_with('%') {
                continue;
            }
            if content.starts_with('\t') {
                return Err((number, failure("a tab is no indentation: write spaces")));
            }
            if indent == 0 && (content == "---" || content == "...") {
                if self.lines.is_empty() || content == "..." {
                    continue;
                }
                return Err((number, failure("the file has a second document")));
            }
            self.lines.push(Line {
                number,
                indent,
                text: content,
            });
        }
        Ok(())
    }

    /// The mapping, sequence or scalar whose lines have an indentation.
    fn block(&mut self, indent: usize) -> YamlResult<Value> {
        let line = &self.lines[self.at];
        self.depth += 1;
        if self.depth > MOST_NESTED {
            return Err((line.number, failure("mappings are nested too deeply")));
        }
        let value = if is_item(line.text) {
            self.sequence(indent)
        } else if key_end(line.text).is_some() {
            self.mapping(indent)
        } else {
            let (number, text) = (line.number, self.joined());
            self.inline(&text, number)
        };
        self.depth -= 1;
        value
    }

    /// The line at hand; with its next lines if it begins a flow collection that does not end in it.
    fn joined(&mut self) -> String {
        let first = &self.lines[self.at];
        let mut text = first.text.to_owned();
        self.at += 1;
        let mut open = depth_of(&text);
        while open > 0
            && let Some(next) = self.lines.get(self.at)
        {
            text.push(' ');
            text.push_str(next.text);
            open += depth_of(next.text);
            self.at += 1;
        }
        text
    }

    fn mapping(&mut self, indent: usize) -> YamlResult<Value> {
        let mut entries = Vec::new();
        let first = self.lines[self.at].number;
        while let Some(line) = self.lines.get(self.at)
            && line.indent == indent
        {
            let (number, text) = (line.number, line.text);
            let Some(end) = key_end(text) else {
                return Err((number, failure(format!("{} has no key", quoted(text)))));
            };
            let key = self.scalar(text[..end].trim(), number)?;
            let rest = text[end + 1..].trim();
            let (anchor, rest) = anchor(rest);
            let value = if rest.is_empty() {
                self.at += 1;
                self.below(indent, true)?
            } else {
                let shift = text.len() - rest.len();
                let joined = self.joined();
                self.inline(&joined[shift..], number)?
            };
            self.name(anchor, &value);
            entries.push((key, value));
        }
        mapping(entries).map_err(|failure| (first, failure))
    }

    /// The value below a key or a dash: the deeper lines. A sequence may be as deep as its key.
    fn below(&mut self, indent: usize, is_key: bool) -> YamlResult<Value> {
        match self.lines.get(self.at) {
            Some(line) if line.indent > indent => {
                let inner = line.indent;
                self.block(inner)
            }
            Some(line) if is_key && line.indent == indent && is_item(line.text) => {
                self.block(indent)
            }
            _ => Ok(Value::None),
        }
    }

    fn sequence(&mut self, indent: usize) -> YamlResult<Value> {
        let mut items = Vec::new();
        let first = self.lines[self.at].number;
        while let Some(line) = self.lines.get_mut(self.at)
            && line.indent == indent
            && is_item(line.text)
        {
            let (anchor, rest) = anchor(line.text[1..].trim_start());
            if rest.is_empty() {
                self.at += 1;
                items.push(self.below(indent, false)?);
            } else {
                // The rest of the line is a block of its own.
                line.indent += line.text.len() - rest.len();
                line.text = rest;
                let inner = line.indent;
                items.push(self.block(inner)?);
            }
            if let Some(value) = items.last() {
                let value = value.clone();
                self.name(anchor, &value);
            }
        }
        Value::list(items).map_err(|failure| (first, failure))
    }

    /// The value of a text in one line.
    fn inline(&mut self, text: &str, number: usize) -> YamlResult<Value> {
        if text.starts_with(['[', '{']) {
            let mut rest = text;
            let value = self.flow(&mut rest, number)?;
            if !rest.trim().is_empty() {
                return Err((
                    number,
                    failure(format!("unexpected {}", quoted(rest.trim()))),
                ));
            }
            return Ok(value);
        }
        if let Some(line) = self.lines.get(self.at)
            && self.at > 0
            && line.indent > self.lines[self.at - 1].indent
            && line.number > number
        {
            return Err((line.number, failure("a scalar continues in a second line")));
        }
        self.scalar(text, number)
    }

    /// A flow mapping, sequence or scalar at the beginning of a text.
    fn flow(&mut self, rest: &mut &str, number: usize) -> YamlResult<Value> {
        *rest = rest.trim_start();
        self.depth += 1;
        if self.depth > MOST_NESTED {
            return Err((number, failure("mappings are nested too deeply")));
        }
        let value = if let Some(inside) = rest.strip_prefix('[') {
            *rest = inside;
            let mut items = Vec::new();
            while !self.closes(rest, ']', number)? {
                items.push(self.flow(rest, number)?);
                self.separates(rest, ']', number)?;
            }
            Value::list(items).map_err(|failure| (number, failure))
        } else if let Some(inside) = rest.strip_prefix('{') {
            *rest = inside;
            let mut entries = Vec::new();
            while !self.closes(rest, '}', number)? {
                let end = key_end(rest);
                let end =
                    end.ok_or_else(|| (number, failure("a mapping has an entry without a key")))?;
                let key = self.scalar(rest[..end].trim(), number)?;
                *rest = &rest[end + 1..];
                entries.push((key, self.flow(rest, number)?));
                self.separates(rest, '}', number)?;
            }
            mapping(entries).map_err(|failure| (number, failure))
        } else {
            let end = scalar_end(rest);
            let (scalar, after) = rest.split_at(end);
            *rest = after;
            self.scalar(scalar.trim(), number)
        };
        self.depth -= 1;
        value
    }

    /// Takes a closing bracket if it comes next.
    #[expect(
        clippy::unused_self,
        reason = "beside the other steps of a flow collection"
    )]
    fn closes(&self, rest: &mut &str, close: char, number: usize) -> YamlResult<bool> {
        *rest = rest.trim_start();
        if rest.is_empty() {
            return Err((
                number,
                failure(format!("{} is missing", quoted(&close.to_string()))),
            ));
        }
        match rest.strip_prefix(close) {
            Some(after) => {
                *rest = after;
                Ok(true)
            }
            None => Ok(false),
        }
    }

    /// Takes a comma, unless a closing bracket comes next.
    #[expect(
        clippy::unused_self,
        reason = "beside the other steps of a flow collection"
    )]
    fn separates(&self, rest: &mut &str, close: char, number: usize) -> YamlResult<()> {
        *rest = rest.trim_start();
        if let Some(after) = rest.strip_prefix(',') {
            *rest = after;
        } else if !rest.is_empty() && !rest.starts_with(close) {
            return Err((number, failure("a comma or a bracket is missing")));
        }
        Ok(())
    }

    /// Keeps the value of an anchor.
    fn name(&mut self, anchor: Option<&str>, value: &Value) {
        if let Some(anchor) = anchor {
            self.anchors.insert(anchor.to_owned(), value.clone());
        }
    }

    /// A scalar with its type, or the value of an anchor.
    fn scalar(&mut self, text: &str, number: usize) -> YamlResult<Value> {
        let at = |failure| (number, failure);
        if let Some(alias) = text.strip_prefix('*') {
            let found = self.anchors.get(alias).cloned();
            let missing = || failure(format!("there is no anchor {}", quoted(alias)));
            return found.ok_or_else(|| at(missing()));
        }
        if text.starts_with('!') {
            let (tag, rest) = text.split_once(' ').unwrap_or((text, ""));
            let Some((_, factor)) = UNITS.iter().find(|(unit, _)| *unit == tag) else {
                let hint = known(tag, "tags", &UNITS.map(|(unit, _)| unit));
                let what = format!("the tag {} is not supported", quoted(tag));
                return Err(at(failure_with_hint(what, hint)));
            };
            let (written, _) = self.scalar_text(rest.trim(), number)?;
            let value = (self.evaluate)(&written).map_err(at)?;
            let value = value.as_number().or_else(|| match &value {
                Value::Text(text) => super::expression::function::float_of(text),
                _ => None,
            });
            let value =
                value.ok_or_else(|| at(failure(format!("{} is no number", quoted(rest)))))?;
            return Ok(Value::Float(value * factor));
        }
        let (written, is_plain) = self.scalar_text(text, number)?;
        if is_plain {
            plain(&written).map_err(at)
        } else {
            Ok(written.into())
        }
    }

    /// The text of a scalar without quotes, and true if it had none.
    #[expect(clippy::unused_self, reason = "beside the other readers of scalars")]
    fn scalar_text(&self, text: &str, number: usize) -> YamlResult<(String, bool)> {
        let at = |what: &str| Err((number, failure(what)));
        let quote = text
            .chars()
            .next()
            .filter(|first| matches!(first, '\'' | '"'));
        let Some(quote) = quote else {
            return match text.chars().next() {
                Some('&') => at("an anchor stands where none is supported"),
                Some('|' | '>') => at("texts of several lines are not supported"),
                Some('@' | '`') => at("a scalar cannot begin with @ or `"),
                _ => Ok((text.to_owned(), true)),
            };
        };
        let inside = text[1..].strip_suffix(quote);
        let Some(inside) = inside.filter(|_| text.len() > 1) else {
            return at("a text in quotes does not end in its line");
        };
        if quote == '\'' {
            return Ok((inside.replace("''", "'"), false));
        }
        let mut out = String::new();
        let mut letters = inside.chars();
        while let Some(letter) = letters.next() {
            if letter != '\\' {
                out.push(letter);
                continue;
            }
            match letters.next() {
                Some('n') => out.push('\n'),
                Some('t') => out.push('\t'),
                Some(same @ ('"' | '\\' | '/')) => out.push(same),
                _ => return at("an escape is not supported"),
            }
        }
        Ok((out, false))
    }
}

/// The anchor at the beginning of a text, and the rest.
fn anchor(text: &str) -> (Option<&str>, &str) {
    match text.strip_prefix('&') {
        None => (None, text),
        Some(rest) => {
            let end = rest.find(' ').unwrap_or(rest.len());
            (Some(&rest[..end]), rest[end..].trim_start())
        }
    }
}

/// A mapping; entries of `<<` are added where the mapping has none of their keys.
fn mapping(entries: Vec<(Value, Value)>) -> Result<Value, Failure> {
    let is_merge = |(key, _): &(Value, Value)| matches!(key, Value::Text(key) if &**key == "<<");
    let (merged, own): (Vec<_>, Vec<_>) = entries.into_iter().partition(is_merge);
    let mut all = Vec::new();
    for (_, value) in merged {
        let maps = match &value {
            Value::Map(_) => vec![value],
            Value::List(list) => list.items().iter().rev().cloned().collect(),
            _ => Vec::new(),
        };
        for map in maps {
            let Value::Map(map) = map else {
                return Err(failure("<< merges mappings"));
            };
            all.extend(map.entries().iter().cloned());
        }
    }
    all.extend(own);
    Map::new(all, true).map(Value::Map)
}

/// A line up to its comment.
fn without_comment(line: &str) -> &str {
    let mut quote = None;
    let mut before = ' ';
    for (at, letter) in line.char_indices() {
        match (quote, letter) {
            (Some(open), _) => quote = Some(open).filter(|open| *open != letter),
            (None, '#') if before.is_whitespace() => return &line[..at],
            // A quote inside a word is an apostrophe.
            (None, '\'' | '"') if before.is_whitespace() || "[{,:".contains(before) => {
                quote = Some(letter);
            }
            _ => {}
        }
        before = letter;
    }
    line
}

/// True if a line is an item of a sequence.
fn is_item(text: &str) -> bool {
    text == "-" || text.starts_with("- ")
}

/// The offset of the colon behind a key.
fn key_end(text: &str) -> Option<usize> {
    let ends = |at: usize| {
        let next = text[at + 1..].chars().next();
        next.is_none_or(char::is_whitespace)
    };
    if let Some(quote) = text
        .chars()
        .next()
        .filter(|first| matches!(first, '\'' | '"'))
    {
        let close = text[1..].find(quote)? + 2;
        let colon = close + (text[close..].len() - text[close..].trim_start().len());
        return (text[colon..].starts_with(':') && ends(colon)).then_some(colon);
    }
    if text.starts_with(['[', '{']) {
        return None;
    }
    let end = text.find(['[', ']', '{', '}', ',']).unwrap_or(text.len());
    let mut colons = text[..end].match_indices(':').map(|(at, _)| at);
    colons.find(|at| ends(*at))
}

/// The end of a scalar in a flow collection.
fn scalar_end(text: &str) -> usize {
    let mut quote = None;
    for (at, letter) in text.char_indices() {
        match (quote, letter) {
            (Some(open), _) => quote = Some(open).filter(|open| *open != letter),
            (None, '\'' | '"') if text[..at].trim().is_empty() => quote = Some(letter),
            (None, ',' | ']' | '}') => return at,
            _ => {}
        }
    }
    text.len()
}

/// Opening minus closing brackets outside quotes.
fn depth_of(text: &str) -> isize {
    let mut quote = None;
    let mut depth = 0;
    for letter in text.chars() {
        match (quote, letter) {
            (Some(open), _) => quote = Some(open).filter(|open| *open != letter),
            (None, '\'' | '"') => quote = Some(letter),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth -= 1,
            _ => {}
        }
    }
    depth
}

/// The value of a scalar without quotes, with the types of YAML 1.1.
fn plain(text: &str) -> Result<Value, Failure> {
    match text {
        "" | "~" | "null" | "Null" | "NULL" => return Ok(Value::None),
        "yes" | "Yes" | "YES" | "true" | "True" | "TRUE" | "on" | "On" | "ON" => {
            return Ok(Value::Bool(true));
        }
        "no" | "No" | "NO" | "false" | "False" | "FALSE" | "off" | "Off" | "OFF" => {
            return Ok(Value::Bool(false));
        }
        ".nan" | ".NaN" | ".NAN" => return Ok(Value::Float(f64::NAN)),
        _ => {}
    }
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1.0, digits),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    if matches!(digits, ".inf" | ".Inf" | ".INF") {
        return Ok(Value::Float(sign * f64::INFINITY));
    }
    let starts = digits.starts_with(|first: char| first.is_ascii_digit() || first == '.');
    if !starts {
        return Ok(text.into());
    }
    if let Some(integer) = integer(digits) {
        let integer = if sign < 0.0 { -integer } else { integer };
        return Value::integer(integer);
    }
    match float(digits) {
        Some(number) => Ok(Value::Float(sign * number)),
        None => Ok(text.into()),
    }
}

/// An integer: decimal, octal with a leading zero, or with the prefix `0x` or `0b`.
fn integer(digits: &str) -> Option<i64> {
    let plain = digits.replace('_', "");
    if let Some(hexadecimal) = plain.strip_prefix("0x") {
        return i64::from_str_radix(hexadecimal, 16).ok();
    }
    if let Some(binary) = plain.strip_prefix("0b") {
        return i64::from_str_radix(binary, 2).ok();
    }
    if plain.is_empty() || !plain.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    if plain.len() > 1 && plain.starts_with('0') {
        return i64::from_str_radix(&plain, 8).ok();
    }
    plain.parse().ok()
}

/// A number with a point, and an exponent with a sign.
fn float(digits: &str) -> Option<f64> {
    let plain = digits.replace('_', "");
    let (mantissa, exponent) = match plain.find(['e', 'E']) {
        Some(at) => (&plain[..at], Some(&plain[at + 1..])),
        None => (&*plain, None),
    };
    let (whole, fraction) = mantissa.split_once('.')?;
    let is_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let is_signed = exponent.is_none_or(|exponent| {
        let digits = exponent.strip_prefix(['+', '-']);
        digits.is_some_and(|digits| !digits.is_empty() && is_digits(digits))
    });
    let has_digits = !whole.is_empty() || !fraction.is_empty();
    (has_digits && is_digits(whole) && is_digits(fraction) && is_signed)
        .then(|| plain.parse().ok())
        .flatten()
}

#[cfg(test)]
mod tests;
