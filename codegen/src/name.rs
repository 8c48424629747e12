//! Names with their places.

use crate::error::Place;

/// A name with its place.
#[derive(Clone, Debug, Default)]
pub struct Name {
    /// The text, as written.
    pub text: String,
    /// Its place in the text.
    pub place: Place,
}

impl From<&str> for Name {
    /// A name without a place, set in code.
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<String> for Name {
    /// A name without a place, set in code.
    fn from(text: String) -> Self {
        Self {
            text,
            place: Place::Unknown,
        }
    }
}
