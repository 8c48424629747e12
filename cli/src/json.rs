//! Prints JSON so that people can read it.
//!
//! A list of numbers or names is on one line, and so is everything that fits, so that a matrix looks like one.
//! Invisible characters are escaped.

use std::fmt::Write;

use serde_json::{Map, Value, json};

use homogen_codegen::wording::is_hidden;

/// Maximum width of a line.
const WIDTH: usize = 100;

/// Version of the JSON answers; it changes if a key is removed or changes its meaning, and not if one is added.
pub(super) const VERSION: u32 = 1;

/// The answer of a command: the value after the version.
pub(super) fn answer(value: Value) -> String {
    let mut answer = Map::new();
    answer.insert("version".to_owned(), json!(VERSION));
    if let Value::Object(entries) = value {
        answer.extend(entries);
    }
    text(&Value::Object(answer))
}

/// The formatted value, with a newline at its end.
fn text(value: &Value) -> String {
    let mut text = String::new();
    write(value, 1, &mut text);
    text.push('\n');
    escaped(&text)
}

/// The value on one line, for an element of HTML: characters of HTML markup are escaped.
pub(super) fn in_markup(value: &Value) -> String {
    let mut text = String::new();
    for letter in escaped(&value.to_string()).chars() {
        match letter {
            // They occur only in strings.
            '<' | '>' | '&' => {
                // Writing to a string cannot fail.
                let _ = write!(text, "\\u{:04x}", u32::from(letter));
            }
            _ => text.push(letter),
        }
    }
    text
}

/// JSON with invisible characters in strings escaped; line breaks occur only between strings.
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
    fn invisible_characters_are_escaped() {
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
