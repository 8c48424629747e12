//! The words for the types of joints.
//!
//! In: a word of a description. Out: the type it names, or the sentence that refuses it.

use crate::wording::{known, list, quoted};

/// A type of joint, before its axis and pitch are known.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Revolute,
    Continuous,
    Prismatic,
    Screw,
    Fixed,
}

const WORDS: [(&str, Kind); 5] = [
    ("revolute", Kind::Revolute),
    ("continuous", Kind::Continuous),
    ("prismatic", Kind::Prismatic),
    ("screw", Kind::Screw),
    ("fixed", Kind::Fixed),
];

/// Types that people ask for and that are not modelled.
const REFUSED: [&str; 7] = [
    "floating",
    "planar",
    "spherical",
    "ball",
    "universal",
    "cylindrical",
    "mimic",
];

/// The type a word names, or a message about the subject and a hint.
pub(super) fn read(word: &str, subject: &str) -> Result<Kind, (String, String)> {
    if let Some((_, kind)) = WORDS.iter().find(|(name, _)| *name == word) {
        return Ok(*kind);
    }
    let words = WORDS.map(|(name, _)| name);
    if REFUSED.contains(&word) {
        let message = format!("{subject} is {word}, and such joints are not modelled");
        return Err((message, format!("known types: {}", list(words))));
    }
    let message = format!("{subject} has the unknown type {}", quoted(word));
    Err((message, known(word, "types", &words)))
}
