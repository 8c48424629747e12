//! The struct with generated functions as methods.
//!
//! In: the declaration of the user, or a name. Out: an [`Item`].

use proc_macro2::{Ident, TokenStream};
use syn::ext::IdentExt;
use syn::{GenericParam, Generics, Visibility, parse_quote};

use super::names::{ident, of_type, type_name, unscoped};
use crate::schedule::Names;

/// The struct.
#[derive(Clone)]
pub struct Item {
    /// Visibility, which the methods share.
    pub visibility: Visibility,
    /// Name.
    pub ident: Ident,
    /// Generic parameters and their bounds.
    pub generics: Generics,
    /// Origin of the declaration.
    pub declaration: Declaration,
}

/// Origin of the declaration of a struct.
#[derive(Clone, Debug)]
pub enum Declaration {
    /// The user has: a derive.
    Exists,
    /// Declared by the front end with these tokens: `chain!`.
    Written(TokenStream),
    /// Declared by the printer with a public field for every parameter: build scripts and the command line.
    Made,
}

impl Item {
    /// Public struct with this name, or a similar one if files have a type with this name.
    #[must_use]
    pub fn made(ident: Ident) -> Self {
        Self {
            visibility: parse_quote! { pub },
            ident: of_type(ident),
            generics: Generics::default(),
            declaration: Declaration::Made,
        }
    }

    /// Public struct with the name of a robot.
    #[must_use]
    pub fn named_after(robot: &str) -> Self {
        Self::made(ident(&type_name(robot)))
    }

    /// Reserved names: its own, which in a pattern would be its only value, and its generic parameters.
    pub(super) fn names(&self) -> Names {
        let mut names = unscoped();
        let mut take = |ident: &Ident| names.take(&ident.unraw().to_string());
        take(&self.ident);
        for parameter in &self.generics.params {
            match parameter {
                GenericParam::Type(parameter) => take(&parameter.ident),
                GenericParam::Const(parameter) => take(&parameter.ident),
                // Lifetimes have a namespace of their own.
                GenericParam::Lifetime(_) => {}
            }
        }
        names
    }
}

#[cfg(test)]
mod tests {
    use super::Item;
    use quote::format_ident;
    use syn::parse_quote;

    #[test]
    fn names_of_the_struct_and_its_parameters_are_reserved() {
        let item = Item {
            generics: parse_quote! { <'t_1, T, const q_1: usize> },
            ..Item::made(format_ident!("k"))
        };
        let mut names = item.names();
        let found = ["q_1", "t_1", "k"].map(|wish| names.fresh(wish));
        assert_eq!(found, ["q_1_", "t_1", "k_"]);
        assert_eq!(names.alone("T"), "T_");
        assert_eq!(Item::made(format_ident!("T")).names().alone("T"), "T_");
    }
}
