//! Places of values and blocks in a text.
//!
//! In: a text, whole or damaged. Out: ranges of its values (names, numbers, words) and of its blocks (elements and
//! attributes, lines, brackets). A damaged text gives those that are still there.

use std::ops::Range;

use super::Language;

/// Ranges of the values, without quotes.
pub(super) fn values(language: Language, text: &str) -> Vec<Range<usize>> {
    match language {
        Language::Urdf | Language::Mjcf => between_quotes(text),
        Language::Xacro => {
            let mut values = between_quotes(text);
            values.extend(runs(text, |c| c.is_alphanumeric() || "_.'".contains(c)));
            values
        }
        Language::Sdf => {
            let mut values = between_quotes(text);
            values.extend(between_tags(text));
            values
        }
        Language::Table => runs(text, |c| !c.is_whitespace()),
        Language::Inline => {
            let mut values = runs(text, |c| c.is_alphanumeric() || "_.-".contains(c));
            values.extend(between_quotes(text));
            values
        }
    }
}

/// Ranges of the blocks, which may be nested.
pub(super) fn blocks(language: Language, text: &str) -> Vec<Range<usize>> {
    let mut blocks = lines(text);
    match language {
        Language::Urdf | Language::Xacro | Language::Mjcf | Language::Sdf => {
            blocks.extend(elements(text));
            // The attribute with the space before it, its name and its quotes.
            blocks.extend(between_quotes(text).into_iter().filter_map(|value| {
                let start = text[..value.start].rfind(' ')?;
                (value.end < text.len()).then_some(start..value.end + 1)
            }));
        }
        Language::Table => blocks.extend(runs(text, |c| !c.is_whitespace())),
        Language::Inline => blocks.extend(groups(text)),
    }
    blocks
}

fn lines(text: &str) -> Vec<Range<usize>> {
    let mut end = 0;
    let ranges = text.split_inclusive('\n').map(|line| {
        let start = end;
        end += line.len();
        start..end
    });
    ranges.collect()
}

/// The longest runs of characters that satisfy a condition.
fn runs(text: &str, is: impl Fn(char) -> bool) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut start = None;
    for (at, letter) in text.char_indices().chain([(text.len(), '\n')]) {
        if at < text.len() && is(letter) {
            start.get_or_insert(at);
        } else if let Some(start) = start.take() {
            found.push(start..at);
        }
    }
    found
}

fn between_quotes(text: &str) -> Vec<Range<usize>> {
    let quotes: Vec<usize> = text.match_indices('"').map(|(at, _)| at).collect();
    quotes
        .chunks_exact(2)
        .map(|pair| pair[0] + 1..pair[1])
        .collect()
}

/// Texts between tags that are not blank.
fn between_tags(text: &str) -> Vec<Range<usize>> {
    let ends = text.match_indices('>').map(|(at, _)| at + 1);
    let found = ends.filter_map(|start| {
        let end = start + text[start..].find('<')?;
        (!text[start..end].trim().is_empty()).then_some(start..end)
    });
    found.collect()
}

/// Elements, from the opening to the closing tag.
fn elements(text: &str) -> Vec<Range<usize>> {
    let mut open = Vec::new();
    let mut found = Vec::new();
    for (start, _) in text.match_indices('<') {
        let Some(length) = text[start..].find('>') else {
            break;
        };
        let end = start + length + 1;
        match text.as_bytes().get(start + 1) {
            Some(b'/') => found.extend(open.pop().map(|first| first..end)),
            Some(b'!' | b'?') => found.push(start..end),
            _ if text[..end].ends_with("/>") => found.push(start..end),
            _ => open.push(start),
        }
    }
    found
}

/// Bracketed groups of any kind, with their brackets.
fn groups(text: &str) -> Vec<Range<usize>> {
    let mut open = Vec::new();
    let mut found = Vec::new();
    for (at, letter) in text.char_indices() {
        match letter {
            '(' | '[' | '{' => open.push(at),
            ')' | ']' | '}' => found.extend(open.pop().map(|first| first..at + 1)),
            _ => {}
        }
    }
    found
}
