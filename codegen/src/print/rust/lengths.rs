//! Lengths of arrays in types.
//!
//! In: numbers or generic parameters. Out: types.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::space::{Space, Spaces};

/// Length of each space.
pub(super) type Lengths<'a> = &'a dyn Fn(Space) -> TokenStream;

/// Lengths of known spaces; for wrenches their number, since each is one value.
pub(super) fn known(spaces: &Spaces) -> impl Fn(Space) -> TokenStream {
    |space| match space {
        Space::Actions => literal(spaces.actions()),
        space => literal(spaces.len(space)),
    }
}

/// Literal of a known length.
pub(super) fn literal(length: usize) -> TokenStream {
    let length = Literal::usize_unsuffixed(length);
    quote! { #length }
}

/// The array type `[T; N]`.
pub(super) fn array(of: &TokenStream, length: &TokenStream) -> TokenStream {
    quote! { [#of; #length] }
}
