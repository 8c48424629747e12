//! Names of joint types.

use crate::joint::{ALL, Definition};
use crate::wording::{known, quoted};

/// Names of joint types in other programs, with the names used here.
const OTHERS: [(&str, &str); 4] = [
    ("ball", "spherical"),
    ("free", "floating"),
    ("hinge", "revolute"),
    ("slide", "prismatic"),
];

/// The joint type with a name, or a message and a hint.
pub(super) fn read(word: &str, subject: &str) -> Result<&'static Definition, (String, String)> {
    if let Some(kind) = ALL.into_iter().find(|kind| kind.word == word) {
        return Ok(kind);
    }
    let words = ALL.map(|kind| kind.word);
    let message = format!("{subject} has the unknown type {}", quoted(word));
    let hint = match OTHERS.into_iter().find(|(other, _)| *other == word) {
        Some((_, own)) => format!("write {own}"),
        None => known(word, "types", &words),
    };
    Err((message, hint))
}

/// The joint type with a name in a table, whose rows have one axis each.
pub(super) fn of_one_axis(
    word: &str,
    subject: &str,
) -> Result<&'static Definition, (String, String)> {
    let kind = read(word, subject)?;
    if kind.axes() > 1 {
        let message = format!("{subject} has the type {word}, but a row of a table has one axis");
        return Err((message, "write a revolute row for each axis".to_owned()));
    }
    Ok(kind)
}
