//! The struct that stands in the user's code.
//!
//! What both macros give to the stages behind: the item as it was written, the description it
//! names or holds, and what is asked for.

use syn::{Attribute, Generics, Ident, LitStr, Visibility};

use super::Description;
use crate::request::Request;

/// A struct with a robot behind it.
#[derive(Clone)]
pub struct Item {
    /// What is written above the struct, except `#[robot(…)]`.
    pub attributes: Vec<Attribute>,
    /// Who sees it.
    pub visibility: Visibility,
    /// Its name.
    pub ident: Ident,
    /// Its generic parameters.
    pub generics: Generics,
    /// The literal that names the description's file, if it stands in a file: a path that begins
    /// at the folder of the user's `Cargo.toml`.
    pub file: Option<LitStr>,
    /// The robot, as far as it could be read.
    pub description: Option<Description>,
    /// What is asked for.
    pub request: Request,
    /// True if `generate` names functions or says `all`.
    pub names_functions: bool,
}
