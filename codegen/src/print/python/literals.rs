//! Literals of Python and TOML.
//!
//! In: any text. Out: literals in quotes, escaped so that no text is read as code.

use std::fmt::Write;

use crate::wording::visible;

/// Lines as a docstring; all lines but the first begin with `indent`.
pub(in crate::print) fn docstring(lines: &[String], indent: &str) -> String {
    let indented = lines
        .iter()
        .enumerate()
        .map(|(k, line)| match (k, &**line) {
            (_, "") => String::new(),
            (0, line) => escaped(&visible(line)),
            (_, line) => format!("{indent}{}", escaped(&visible(line))),
        });
    let text = indented.collect::<Vec<_>>().join("\n");
    let end = if lines.len() > 1 {
        format!("\n{indent}")
    } else {
        String::new()
    };
    format!("\"\"\"{text}{end}\"\"\"")
}

/// Text in quotes with all its characters, for Python and TOML.
pub(in crate::print) fn string(text: &str) -> String {
    let mut literal = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => literal.extend(['\\', letter]),
            ' '..='~' => literal.push(letter),
            // Writing to a string cannot fail.
            _ => drop(write!(literal, "\\U{:08x}", u32::from(letter))),
        }
    }
    literal.push('"');
    literal
}

fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        if matches!(letter, '"' | '\\') {
            escaped.push('\\');
        }
        escaped.push(letter);
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::{docstring, string};

    #[test]
    fn nothing_in_a_literal_is_code() {
        for (text, literal) in [
            ("\"\"\"; import os #", r#""\"\"\"; import os #""#),
            ("a\\", r#""a\\""#),
            (
                "a\nb\u{202e}é\0",
                "\"a\\U0000000ab\\U0000202e\\U000000e9\\U00000000\"",
            ),
        ] {
            assert_eq!(string(text), literal);
        }
        let lines = [
            "\"\"\" \\".to_owned(),
            String::new(),
            "τ\n\u{202e}".to_owned(),
        ];
        assert_eq!(
            docstring(&lines, "  "),
            "\"\"\"\\\"\\\"\\\" \\\\\n\n  τ\\\\u{a}\\\\u{202e}\n  \"\"\""
        );
        assert_eq!(docstring(&["τ".to_owned()], ""), "\"\"\"τ\"\"\"");
    }
}
