//! How long arrays are, as types have it.
//!
//! In: numbers, or names that stand for them. Out: types. It never knows what is in an array.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::space::{Space, Spaces};

/// A length for each space.
pub(super) type Lengths<'a> = &'a dyn Fn(Space) -> TokenStream;

/// Those of spaces that are known; of actions how many there are, for each is one thing.
pub(super) fn known(spaces: &Spaces) -> impl Fn(Space) -> TokenStream {
    |space| match space {
        Space::Actions => literal(spaces.actions()),
        space => literal(spaces.len(space)),
    }
}

/// A length that is known.
pub(super) fn literal(length: usize) -> TokenStream {
    let length = Literal::usize_unsuffixed(length);
    quote! { #length }
}

/// The type of so many of a type.
pub(super) fn array(of: &TokenStream, length: &TokenStream) -> TokenStream {
    quote! { [#of; #length] }
}
