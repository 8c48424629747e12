//! The struct that generated functions are methods of.
//!
//! In: what the user declared, or a name for a struct to be made. Out: an [`Item`]. It never looks at
//! a robot.

use proc_macro2::{Ident, TokenStream};
use syn::ext::IdentExt;
use syn::{GenericParam, Generics, Visibility, parse_quote};

use super::names::{ident, of_type, type_name, unscoped};
use crate::schedule::Names;

/// The struct, as its door sees it.
#[derive(Clone)]
pub struct Item {
    /// Its visibility, which the methods share.
    pub visibility: Visibility,
    /// Its name.
    pub ident: Ident,
    /// Its generic parameters and their bounds.
    pub generics: Generics,
    /// Who declares it.
    pub declaration: Declaration,
}

/// Who declares the struct.
#[derive(Clone, Debug)]
pub enum Declaration {
    /// The user has: a derive.
    Exists,
    /// The door has, in these tokens: `chain!`.
    Written(TokenStream),
    /// This stage does, with a public field for every parameter: build scripts, the command line.
    Made,
}

impl Item {
    /// A public struct to be made, called like this as far as files have no type of that name.
    #[must_use]
    pub fn made(ident: Ident) -> Self {
        Self {
            visibility: parse_quote! { pub },
            ident: of_type(ident),
            generics: Generics::default(),
            declaration: Declaration::Made,
        }
    }

    /// A public struct to be made, called as a robot is.
    #[must_use]
    pub fn named_after(robot: &str) -> Self {
        Self::made(ident(&type_name(robot)))
    }

    /// Names beside its own, which in a pattern would be taken for its only value, and those of its
    /// generic parameters.
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
    fn the_struct_and_its_generic_parameters_are_left_alone() {
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
