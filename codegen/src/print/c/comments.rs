//! Comments above C.
//!
//! In: lines of `documentation`. Out: comments, escaped so that no text in them is read as code.

use crate::wording::visible;

/// Comment of these lines.
pub(super) fn comment(lines: &[String]) -> String {
    let mut text = "/*".to_owned();
    for (k, line) in lines.iter().enumerate() {
        text.push_str(if k == 0 { "" } else { "\n *" });
        let line = harmless(line.trim_end_matches(' '));
        text.extend((!line.is_empty()).then_some(" "));
        text.push_str(&line);
    }
    text + "\n */\n"
}

/// A text without comment delimiters, trigraphs or a continuation of its line.
pub(super) fn harmless(text: &str) -> String {
    let mut harmless = String::with_capacity(text.len());
    let mut last = ' ';
    for letter in visible(text).chars() {
        if matches!((last, letter), ('*', '/') | ('/', '*') | ('?', '?')) {
            harmless.push(' ');
        }
        harmless.push(letter);
        last = letter;
    }
    if last == '\\' {
        harmless.push('.');
    }
    harmless
}

#[cfg(test)]
mod tests {
    use super::harmless;

    #[test]
    fn nothing_in_a_comment_is_code() {
        for (text, shown) in [
            ("a */ b /* c", "a * / b / * c"),
            ("/*/", "/ * /"),
            ("**//", "** //"),
            ("??/", "? ?/"),
            ("???/", "? ? ?/"),
            ("*??/\n/", "*? ?/\\u{a}/"),
            ("so on \\", "so on \\."),
            ("\"q̈\" in rad/s²", "\"q̈\" in rad/s²"),
        ] {
            assert_eq!(harmless(text), shown);
        }
    }
}
