//! The words for the types of joints.
//!
//! In: a word of a description. Out: the type it names, or the sentence that refuses it.

use crate::joint::{ALL, Definition};
use crate::wording::{known, list, quoted};

/// Types that people ask for and that are not modelled.
const REFUSED: [&str; 6] = [
    "floating",
    "planar",
    "spherical",
    "ball",
    "universal",
    "mimic",
];

/// The type a word names, or a message about the subject and a hint.
pub(super) fn read(word: &str, subject: &str) -> Result<&'static Definition, (String, String)> {
    if let Some(kind) = ALL.into_iter().find(|kind| kind.word == word) {
        return Ok(kind);
    }
    let words = ALL.map(|kind| kind.word);
    if REFUSED.contains(&word) {
        let message = format!("{subject} is {word}, and such joints are not modelled");
        return Err((message, format!("known types: {}", list(words))));
    }
    let message = format!("{subject} has the unknown type {}", quoted(word));
    Err((message, known(word, "types", &words)))
}
