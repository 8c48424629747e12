//! A name as it was written, and where.

use crate::error::Place;

/// A name and its place.
#[derive(Clone, Debug, Default)]
pub struct Name {
    /// The text, as written.
    pub text: String,
    /// Where it stands.
    pub place: Place,
}

impl From<&str> for Name {
    /// A name that was written nowhere: a build script's.
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<String> for Name {
    /// The same.
    fn from(text: String) -> Self {
        Self {
            text,
            place: Place::Unknown,
        }
    }
}
