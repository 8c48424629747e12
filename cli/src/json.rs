//! JSON as it is printed.
//!
//! In: a value. Out: text in which a list of numbers or names is one line, and whatever fits a
//! line is one, so that a matrix can be read; what cannot be seen is an escape. It never changes a
//! number or a name.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use homogen_codegen::error::{Complaint, Place};
use homogen_codegen::wording::is_hidden;

/// What fits a line.
const WIDTH: usize = 100;

/// The version of what commands answer in JSON: another one where a key goes or means something else, and the same
/// where keys come.
pub(super) const VERSION: u32 = 1;

/// What a command answers: the value behind the version.
pub(super) fn answer(value: Value) -> String {
    let mut answer = Map::new();
    answer.insert("version".to_owned(), json!(VERSION));
    if let Value::Object(entries) = value {
        answer.extend(entries);
    }
    text(&Value::Object(answer))
}

/// The value, formatted, with a newline at its end.
fn text(value: &Value) -> String {
    let mut text = String::new();
    write(value, 1, &mut text);
    text.push('\n');
    escaped(&text)
}

/// The value on one line, for the inside of an element of HTML: no mark of HTML is left in it.
pub(super) fn in_markup(value: &Value) -> String {
    let mut text = String::new();
    for letter in escaped(&value.to_string()).chars() {
        match letter {
            // Beyond strings there are none.
            '<' | '>' | '&' => {
                // Writing to a string cannot fail.
                let _ = write!(text, "\\u{:04x}", u32::from(letter));
            }
            _ => text.push(letter),
        }
    }
    text
}

/// Doubts with their places.
pub(super) fn warnings(doubts: &[Complaint]) -> Value {
    let doubts = doubts.iter().map(|doubt| {
        let (line, column) = line_and_column(doubt.place);
        json!({ "line": line, "column": column, "message": doubt.message, "hint": doubt.hint })
    });
    doubts.collect()
}

/// JSON whose strings have the escapes that JSON has for what a terminal or a reader would be
/// deceived by; line breaks are between strings alone.
fn escaped(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        if letter != '\n' && is_hidden(letter) {
            for unit in letter.encode_utf16(&mut [0; 2]) {
                // Writing to a string cannot fail.
                let _ = write!(shown, "\\u{unit:04x}");
            }
        } else {
            shown.push(letter);
        }
    }
    shown
}

/// The line and the column of a place, null where it has none in the description's own file.
pub(super) fn line_and_column(place: Place) -> (Value, Value) {
    match place {
        Place::File { line, column } => (json!(line), json!(column)),
        Place::Included { .. } | Place::Token(_) | Place::Unknown => (Value::Null, Value::Null),
    }
}

fn write(value: &Value, depth: usize, text: &mut String) {
    let compact = value.to_string();
    let indent = |text: &mut String, depth: usize| {
        text.push('\n');
        text.extend(std::iter::repeat_n("  ", depth));
    };
    match value {
        Value::Object(entries) if compact.len() > WIDTH || depth == 1 => {
            text.push('{');
            for (k, (key, entry)) in entries.iter().enumerate() {
                text.push_str(if k == 0 { "" } else { "," });
                indent(text, depth);
                // Writing to a string cannot fail.
                let _ = write!(text, "{}: ", json!(key));
                write(entry, depth + 1, text);
            }
            indent(text, depth - 1);
            text.push('}');
        }
        Value::Array(entries) if compact.len() > WIDTH && entries.iter().any(is_nested) => {
            text.push('[');
            for (k, entry) in entries.iter().enumerate() {
                text.push_str(if k == 0 { "" } else { "," });
                indent(text, depth);
                write(entry, depth + 1, text);
            }
            indent(text, depth - 1);
            text.push(']');
        }
        _ => text.push_str(&compact),
    }
}

fn is_nested(value: &Value) -> bool {
    value.is_array() || value.is_object()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_be_seen_is_an_escape() {
        let name = "a\u{202e}b\n\u{1b}\u{7f}\u{85}\u{e0041}é\\";
        let text = text(&json!({ name: [name] }));
        assert!(!text.contains(|c| c != '\n' && is_hidden(c)), "{text}");
        assert_eq!(text.lines().count(), 3);
        let read: Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(read, json!({ name: [name] }));
    }

    #[test]
    fn lists_of_numbers_stay_on_a_line() {
        let numbers: Vec<f64> = (0..60).map(f64::from).collect();
        let value = json!({ "z": numbers, "a": [numbers, numbers], "m": [[1, 0], [0, 1]] });
        let text = text(&value);
        assert_eq!(text.lines().count(), 8);
        assert!(text.ends_with("  ],\n  \"m\": [[1,0],[0,1]]\n}\n"));
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), value);
    }
}
