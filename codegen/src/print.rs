//! Printing, the last stage: text of a module in each language.
//!
//! In: a [`Module`](crate::module::Module). Out: text. Each language has a folder; everything that languages share is
//! here. Operations and their order stay as they are.

#[cfg(feature = "files")]
pub mod arrays;
#[cfg(feature = "files")]
pub(crate) mod ascii;
#[cfg(feature = "files")]
pub mod c;
mod copies;
pub mod described;
mod documentation;
mod expression;
mod large;
#[cfg(feature = "files")]
pub mod llvm;
#[cfg(feature = "files")]
pub mod plain_python;
#[cfg(feature = "files")]
pub mod python;
#[cfg(feature = "files")]
mod review;
pub mod rust;
#[cfg(feature = "files")]
mod sines;
mod steps;
mod walk;

use crate::request::Parameter;

/// Fields of the struct that programs read.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Fields<'l> {
    /// Fields of the user.
    Own(&'l [Parameter]),
    /// One field with values computed from those of the user; the strings are their preferred names.
    Computed(&'l [String]),
}

impl Fields<'_> {
    /// Preferred names of the entries of each field.
    pub(crate) fn entries(self) -> Vec<Vec<String>> {
        match self {
            Self::Own(parameters) => parameters.iter().map(Parameter::entries).collect(),
            Self::Computed(names) => vec![names.to_vec()],
        }
    }
}
