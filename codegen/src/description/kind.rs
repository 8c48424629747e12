//! The words for the types of joints.
//!
//! In: a word of a description. Out: the type it names, or the sentence that refuses it.

use crate::joint::{ALL, Definition};
use crate::wording::{known, quoted};

/// Other words for what is known by one of its own.
const OTHERS: [(&str, &str); 4] = [
    ("ball", "spherical"),
    ("free", "floating"),
    ("hinge", "revolute"),
    ("slide", "prismatic"),
];

/// The type a word names, or a message about the subject and a hint.
pub(super) fn read(word: &str, subject: &str) -> Result<&'static Definition, (String, String)> {
    if let Some(kind) = ALL.into_iter().find(|kind| kind.word == word) {
        return Ok(kind);
    }
    let words = ALL.map(|kind| kind.word);
    let message = format!("{subject} has the unknown type {}", quoted(word));
    let hint = match OTHERS.into_iter().find(|(other, _)| *other == word) {
        Some((_, own)) => format!("it is called {own} here"),
        None => known(word, "types", &words),
    };
    Err((message, hint))
}

/// The type a word names in a table, whose rows have one axis each.
pub(super) fn of_one_axis(
    word: &str,
    subject: &str,
) -> Result<&'static Definition, (String, String)> {
    let kind = read(word, subject)?;
    if kind.axes() > 1 {
        let message = format!("{subject} is {word}, and a table gives it one axis");
        return Err((message, "write two rows that turn".to_owned()));
    }
    Ok(kind)
}
