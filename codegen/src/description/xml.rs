//! XML, as far as a robot's description needs it.
//!
//! In: a plain text. Out: a document whose reading took time and memory in proportion to the text, or
//! one complaint. It never replaces entities, and never lets through what makes the XML reader
//! slow: elements with hundreds of attributes, hundreds of namespaces.

pub(super) mod element;
pub(super) mod elements;
pub(super) mod plain;
pub(super) mod survey;

use roxmltree::{Document, Error, ParsingOptions};

use crate::description::position::Positions;
use crate::error::{Errors, Place};
use crate::wording::quoted;

/// The most bytes of a file.
pub const LARGEST_FILE: usize = 64 << 20;

/// The most nodes of a document (elements, attributes, pieces of text between them): with this
/// many, the document takes some 150 MB.
const MOST_NODES: u32 = 1_000_000;

/// The most attributes of an element: each is compared with each.
const MOST_ATTRIBUTES: usize = 32;

/// The most declarations of namespaces: elements that declare one copy all those around them.
const MOST_NAMESPACES: usize = 64;

/// Parses a text whose places are those of the file, or pushes one complaint, whose hint may be how files of the format
/// begin.
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

/// Refuses what would take time or memory out of proportion; says where, and what.
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
        // An unfinished comment is for the XML reader to complain about.
        let Some(next) = skipped else { break };
        at = next;
    }
    Ok(())
}

fn find(text: &str, from: usize, word: &str) -> Option<usize> {
    text[from..].find(word).map(|offset| from + offset)
}

/// The equals signs outside quotes, up to the end of the tag.
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

/// Says what the XML reader found.
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
            format!("</{}> closes nothing", cut(actual)),
            format!(
                "the element that is open here ends with </{}>",
                cut(expected)
            ),
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
            errors.push(place, format!("attribute {} is given twice", quoted(name)));
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

/// A name of any length, cut to what fits a message.
fn cut(name: &str) -> String {
    quoted(name).trim_matches('"').to_owned()
}
