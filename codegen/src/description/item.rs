//! The struct in the user's code, as read by both macros: the item itself, its description, and the request.

use syn::{Attribute, Generics, Ident, LitStr, Visibility};

use super::Description;
use crate::request::Request;

/// A struct that becomes a robot.
#[derive(Clone)]
pub struct Item {
    /// Attributes of the struct, except `#[robot(…)]`.
    pub attributes: Vec<Attribute>,
    /// Visibility of the struct.
    pub visibility: Visibility,
    /// Its name.
    pub ident: Ident,
    /// Its generic parameters.
    pub generics: Generics,
    /// The literal with the description's path, relative to the folder of the user's `Cargo.toml`; `None` for an inline
    /// description.
    pub file: Option<LitStr>,
    /// The description; partial, or `None`, if there are errors.
    pub description: Option<Description>,
    /// The request.
    pub request: Request,
    /// True if `generate` names functions or says `all`.
    pub names_functions: bool,
    /// The fields without an attribute whose type may be a number.
    pub own_fields: Vec<Ident>,
}
