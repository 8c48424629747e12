//! The last stage: what is printed for a robot.
//!
//! In: the programs of a robot and what is to be said about them, as a [`Module`](crate::module::Module). Out: text in a
//! language, which has a room of its own below and finds here what every language shares. It never
//! computes a number, changes an operation or chooses an order.

#[cfg(feature = "files")]
pub(crate) mod ascii;
#[cfg(feature = "files")]
pub mod c;
mod described;
mod documentation;
mod large;
#[cfg(feature = "files")]
pub mod llvm;
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

/// What programs read of a struct.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Fields<'l> {
    /// What the user puts into it.
    Own(&'l [Parameter]),
    /// What has been computed of that: one field, whose entries would like these names.
    Computed(&'l [String]),
}

impl Fields<'_> {
    /// The names that the entries of each would like.
    pub(crate) fn entries(self) -> Vec<Vec<String>> {
        match self {
            Self::Own(parameters) => parameters.iter().map(Parameter::entries).collect(),
            Self::Computed(names) => vec![names.to_vec()],
        }
    }
}
