//! JSON as it is printed.
//!
//! In: a value. Out: text in which a list of numbers or names is one line, and whatever fits a
//! line is one, so that a matrix can be read. It never changes a number.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::error::Place;

/// What fits a line.
const WIDTH: usize = 100;

/// The value, formatted, with a newline at its end.
pub(super) fn text(value: &Value) -> String {
    let mut text = String::new();
    write(value, 1, &mut text);
    text.push('\n');
    text
}

/// The line and the column of a place, null where it has none.
pub(super) fn line_and_column(place: Place) -> (Value, Value) {
    match place {
        Place::File { line, column } => (json!(line), json!(column)),
        Place::Token(_) | Place::Unknown => (Value::Null, Value::Null),
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
    fn lists_of_numbers_stay_on_a_line() {
        let numbers: Vec<f64> = (0..60).map(f64::from).collect();
        let value = json!({ "z": numbers, "a": [numbers, numbers], "m": [[1, 0], [0, 1]] });
        let text = text(&value);
        assert_eq!(text.lines().count(), 8);
        assert!(text.ends_with("  ],\n  \"m\": [[1,0],[0,1]]\n}\n"));
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), value);
    }
}
