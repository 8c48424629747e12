//! The struct that generated functions are methods of.
//!
//! In: what the user declared, or a name for a struct to be made. Out: its declaration, where the
//! door has to write it, and the blocks around methods. It never looks at what the methods do.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{GenericParam, Generics, Visibility, parse_quote};

use super::Listing;
use super::dialect::{Dialect, World};
use super::documentation;
use crate::request::Target;

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
    /// The struct under a derive.
    #[cfg(test)]
    pub(super) fn derived(input: &syn::DeriveInput) -> Self {
        Self {
            visibility: input.vis.clone(),
            ident: input.ident.clone(),
            generics: input.generics.clone(),
            declaration: Declaration::Exists,
        }
    }

    /// A public struct to be made.
    #[must_use]
    pub fn made(ident: Ident) -> Self {
        Self {
            visibility: parse_quote! { pub },
            ident,
            generics: Generics::default(),
            declaration: Declaration::Made,
        }
    }
}

/// The struct itself, where it has to be written.
pub(super) fn declaration(listing: &Listing, dialect: &Dialect) -> TokenStream {
    match &listing.item.declaration {
        Declaration::Exists => TokenStream::new(),
        Declaration::Written(tokens) => tokens.clone(),
        Declaration::Made => made(listing, dialect),
    }
}

fn made(listing: &Listing, dialect: &Dialect) -> TokenStream {
    let Item {
        visibility, ident, ..
    } = &listing.item;
    let about = documentation::of_robot(listing);
    let derive = match dialect.world {
        World::Runtime(_) => quote! {
            #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        },
        World::Core(_) => quote! { #[derive(Clone, Copy, Debug)] },
    };
    let number = dialect.field();
    let fields = listing.parameters.iter().map(|parameter| {
        let field = &parameter.field;
        let about = documentation::of_field(&parameter.target);
        let kind = if is_array(&parameter.target) {
            quote! { [#number; 3] }
        } else {
            number.clone()
        };
        quote! { #about pub #field: #kind, }
    });
    let layout = dialect.is_for_c().then(|| quote! { #[repr(C)] });
    if listing.parameters.is_empty() {
        quote! { #about #derive #visibility struct #ident; }
    } else {
        quote! { #about #derive #layout #visibility struct #ident { #(#fields)* } }
    }
}

/// Whether a field holds three numbers rather than one.
pub(super) const fn is_array(target: &Target) -> bool {
    !matches!(target, Target::MassOf(_))
}

/// The block of inherent methods.
pub(super) fn block(item: &Item, methods: &TokenStream, dialect: &Dialect) -> TokenStream {
    let ident = &item.ident;
    let (generics, arguments, bounds) = item.generics.split_for_impl();
    // Compilers before 1.81 know no reasons, and code for `core` alone is for those as well.
    let reason = match dialect.world {
        World::Runtime(_) => {
            quote! { reason = "generated code has one form for every robot" }
        }
        World::Core(_) => TokenStream::new(),
    };
    quote! {
        #[allow(
            clippy::similar_names,
            clippy::too_many_lines,
            clippy::trivially_copy_pass_by_ref,
            clippy::unreadable_literal,
            clippy::unused_self,
            #reason
        )]
        impl #generics #ident #arguments #bounds { #methods }
    }
}

/// The head of an implementation of a trait, up to its brace.
pub(super) fn implementation(item: &Item, of: &TokenStream, more: &[GenericParam]) -> TokenStream {
    let ident = &item.ident;
    let (_, arguments, bounds) = item.generics.split_for_impl();
    let mut generics = item.generics.clone();
    generics.params.extend(more.iter().cloned());
    let (generics, _, _) = generics.split_for_impl();
    quote! { #[automatically_derived] impl #generics #of for #ident #arguments #bounds }
}
