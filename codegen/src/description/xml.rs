//! Parses XML in time and memory proportional to the text.
//!
//! Entities are not replaced. Elements with many attributes and files with many namespaces are rejected, because the
//! XML parser is slow on them.

pub(super) mod element;
pub(super) mod elements;
pub(super) mod plain;
pub(super) mod survey;
#[cfg(feature = "formats")]
pub(super) mod texts;

use roxmltree::{Document, Error, ParsingOptions};

use crate::description::position::Positions;
use crate::error::{Errors, Place};
use crate::wording::quoted;

/// Maximum size of a file in bytes.
pub const LARGEST_FILE: usize = 64 << 20;

/// Maximum number of nodes of a document (elements, attributes, pieces of text). A document of this size takes about
/// 150 MB.
const MOST_NODES: u32 = 1_000_000;

/// Maximum number of attributes of an element: the parser compares each with each.
const MOST_ATTRIBUTES: usize = 128;

/// Maximum number of namespace declarations: an element that declares one copies all outer ones.
const MOST_NAMESPACES: usize = 64;

/// True if the root element of a text begins so.
pub(super) fn begins_with(text: &str, tag: &str) -> bool {
    let mut rest = text.trim_start_matches('\u{feff}').trim_start();
    loop {
        let after = |word: &str| rest.find(word).map(|at| at + word.len());
        let end = match rest {
            _ if rest.starts_with("<!--") => after("-->"),
            _ if rest.starts_with("<?") => after("?>"),
            _ if rest.starts_with("<!DOCTYPE") => plain::end_of_type(rest),
            _ if rest.starts_with("<!") => after(">"),
            _ => break,
        };
        let Some(end) = end else {
            return false;
        };
        rest = rest[end..].trim_start();
    }
    rest.starts_with(tag)
}

/// Parses a text, or reports one error. `positions` are those of the file; `begins` is the hint for a text that is not
/// XML: the beginning of a file of the format.
pub(super) fn parse<'t>(
    text: &'t str,
    positions: &Positions<'_>,
    begins: &str,
    errors: &mut Errors,
) -> Option<Document<'t>> {
    if text.trim().is_empty() {
        errors.push(Place::Unknown, "the file is empty");
        return None;
    }
    if let Err((offset, message)) = check_size(text) {
        errors.push(positions.place(offset), message);
        return None;
    }
    let options = ParsingOptions {
        allow_dtd: false,
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    match Document::parse_with_options(text, options) {
        Ok(document) => Some(document),
        Err(error) => {
            complain(&error, positions, begins, errors);
            None
        }
    }
}

/// Rejects texts that would take disproportionate time or memory; returns the offset and the message.
fn check_size(text: &str) -> Result<(), (usize, String)> {
    if text.len() > LARGEST_FILE {
        let message = format!("the file is larger than {} MB", LARGEST_FILE >> 20);
        return Err((0, message));
    }
    let mut nodes = 0_usize;
    let mut namespaces = 0;
    let mut at = 0;
    while let Some(start) = text[at..].find('<').map(|offset| at + offset) {
        let skipped = if text[start..].starts_with("<!--") {
            find(text, start, "-->")
        } else if text[start..].starts_with("<![CDATA[") {
            find(text, start, "]]>")
        } else if text[start..].starts_with("<?") {
            find(text, start, "?>")
        } else {
            let tag = text[start + 1..].split('<').next().unwrap_or_default();
            let attributes = count_attributes(tag);
            if attributes > MOST_ATTRIBUTES {
                let message = format!("an element has more than {MOST_ATTRIBUTES} attributes");
                return Err((start, message));
            }
            nodes += attributes;
            namespaces += tag.matches("xmlns").count();
            Some(start + 1)
        };
        nodes += 1;
        if nodes > MOST_NODES as usize {
            let message = format!("the file has more than {MOST_NODES} elements and attributes");
            return Err((start, message));
        }
        if namespaces > MOST_NAMESPACES {
            let message = format!("the file declares more than {MOST_NAMESPACES} namespaces");
            return Err((start, message));
        }
        // An unfinished comment is reported by the XML parser.
        let Some(next) = skipped else { break };
        at = next;
    }
    Ok(())
}

fn find(text: &str, from: usize, word: &str) -> Option<usize> {
    text[from..].find(word).map(|offset| from + offset)
}

/// Counts the equals signs outside quotes, up to the end of the tag.
fn count_attributes(tag: &str) -> usize {
    let mut quote = None;
    let mut count = 0;
    for byte in tag.bytes() {
        match (quote, byte) {
            (Some(open), _) if byte == open => quote = None,
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'=') => count += 1,
            (None, b'>') => break,
            _ => {}
        }
    }
    count
}

/// Reports an error of the XML parser.
fn complain(error: &Error, positions: &Positions<'_>, begins: &str, errors: &mut Errors) {
    let found = error.pos();
    let place = positions.at(found.row, found.col);
    let end = positions.place(positions.text().trim_end().len());
    match error {
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => errors.push_with_hint(
            end,
            "the file ends in the middle of an element",
            "is the file complete?",
        ),
        Error::UnexpectedCloseTag(expected, actual, _) => errors.push_with_hint(
            place,
            format!("</{}> has no matching start tag", cut(actual)),
            format!("close the open element by </{}>", cut(expected)),
        ),
        Error::DtdDetected => {
            let offset = positions.text().find("<!DOCTYPE").unwrap_or(0);
            errors.push_with_hint(
                positions.place(offset),
                "<!DOCTYPE …> does not end",
                "remove it",
            );
        }
        Error::DuplicatedAttribute(name, _) => {
            errors.push(place, format!("attribute {} occurs twice", quoted(name)));
        }
        Error::NodesLimitReached => errors.push(
            Place::Unknown,
            format!("the file has more than {MOST_NODES} elements"),
        ),
        Error::NoRootNode => errors.push(place, "the file has no element"),
        Error::UnknownToken(_) => errors.push_with_hint(place, "this is not XML", begins),
        other => {
            let detail = other.to_string().replace(&format!(" at {found}"), "");
            errors.push(place, format!("this is not well-formed XML: {detail}"));
        }
    }
}

/// A name, shortened for a message.
fn cut(name: &str) -> String {
    quoted(name).trim_matches('"').to_owned()
}
