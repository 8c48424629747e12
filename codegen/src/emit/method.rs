//! One generated function: its signature, its doc comment, its body, its trait.
//!
//! In: a [`Listed`] of a [`Listing`]. Out: an inherent method, and the implementation of a trait
//! that calls it. It never prints an operation itself.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use syn::{GenericParam, parse_quote};

use super::body::{Body, body};
use super::dialect::{Dialect, World};
use super::lengths::Lengths;
use super::names::{ident, unscoped};
use super::results::{result_type, result_value};
use super::{Item, Listed, Listing, documentation, item, sines};
use crate::function::Function;
use crate::space::{Space, Variable};

/// The method that computes `listed`.
pub(super) fn method(
    listing: &Listing,
    listed: &Listed,
    name: &Ident,
    dialect: &Dialect,
) -> TokenStream {
    let arguments = arguments(&listed.functions);
    let Body {
        statements,
        results,
    } = body(&listed.program, &arguments, listing, dialect);
    let result = result_value(&listed.functions, &listing.spaces, &results, dialect);

    let about = documentation::of_method(listing, listed, dialect);
    let visibility = &listing.item.visibility;
    let lengths = Lengths::of_spaces(&listing.spaces);
    let signature = signature(name, &listed.functions, &lengths, None, dialect);
    quote! {
        #about
        #[must_use]
        #visibility #signature { #statements #result }
    }
}

/// The implementation of a function's trait by the method `name`.
pub(super) fn in_trait(
    listing: &Listing,
    function: Function,
    name: &Ident,
    dialect: &Dialect,
) -> TokenStream {
    let arguments = function.arguments().iter();
    let arguments = arguments.map(|argument| format_ident!("{}", argument.name()));
    let call = quote! { Self::#name(self, #(#arguments),*) };
    implementation(
        &listing.item,
        function,
        &Lengths::of_spaces(&listing.spaces),
        None,
        &call,
        dialect,
    )
}

/// The implementation of a function's trait, for arrays of the given lengths (which may be the
/// parameter `unknown`) and with the given body.
pub(super) fn implementation(
    item: &Item,
    function: Function,
    lengths: &Lengths,
    unknown: Option<GenericParam>,
    call: &TokenStream,
    dialect: &Dialect,
) -> TokenStream {
    let World::Runtime(runtime) = &dialect.world else {
        return TokenStream::new();
    };
    let number = &dialect.number;
    let generic: Option<GenericParam> = dialect
        .generic
        .as_ref()
        .map(|generic| parse_quote! { #generic: #runtime::Scalar });
    let more: Vec<_> = unknown.into_iter().chain(generic).collect();
    // The traits are called as the functions are, in the case of types.
    let name = format_ident!("{function:?}");
    let count = lengths.of(Space::Velocities);
    let of = quote! { #runtime::robot::#name<#count, #number> };
    let head = item::implementation(item, &of, &more);
    let method = format_ident!("{}", function.name());
    let result = result_type(&[function], lengths, dialect);
    let parameters = parameters(function.arguments(), lengths, dialect);
    quote! {
        #head {
            #[inline]
            fn #method(&self, #parameters) -> #result { #call }
        }
    }
}

/// `fn gravity<T: ::homogen::Scalar>(&self, q: &[T; 2]) -> [T; 2]`; `unknown` is a generic
/// parameter that stands for the number of joints.
pub(super) fn signature(
    name: &Ident,
    functions: &[Function],
    lengths: &Lengths,
    unknown: Option<&TokenStream>,
    dialect: &Dialect,
) -> TokenStream {
    let generic = dialect
        .generic
        .as_ref()
        .map(|generic| match &dialect.world {
            World::Runtime(runtime) => quote! { #generic: #runtime::Scalar, },
            World::Core(_) => TokenStream::new(),
        });
    let generics = match (generic, unknown) {
        (None, None) => TokenStream::new(),
        (generic, unknown) => quote! { <#generic #unknown> },
    };
    let parameters = parameters(&arguments(functions), lengths, dialect);
    let result = result_type(functions, lengths, dialect);
    quote! { fn #name #generics(&self, #parameters) -> #result }
}

fn parameters(arguments: &[Variable], lengths: &Lengths, dialect: &Dialect) -> TokenStream {
    let number = &dialect.number;
    let parameters = arguments.iter().map(|argument| {
        let name = format_ident!("{}", argument.name());
        let length = lengths.of(argument.space());
        quote! { #name: &[#number; #length] }
    });
    quote! { #(#parameters),* }
}

/// The names of all methods, in the order of the listing; none is that of a function that a struct
/// has besides.
pub(super) fn names(listing: &Listing) -> Vec<Ident> {
    let mut names = unscoped();
    names.take("chain");
    names.take(sines::NAME);
    let listed = listing.functions.iter();
    listed
        .map(|listed| ident(&names.fresh(&listed.name())))
        .collect()
}

/// What several functions together are functions of.
pub(super) fn arguments(functions: &[Function]) -> Vec<Variable> {
    Variable::together(functions.iter().map(|function| function.arguments()))
}

/// `mass_matrix_and_bias`, `forward_kinematics_of_camera`.
pub(super) fn name(functions: &[Function], frame: Option<&str>) -> String {
    let names: Vec<_> = functions.iter().map(|function| function.name()).collect();
    let name = names.join("_and_");
    match frame {
        Some(frame) => format!("{name}_of_{frame}"),
        None => name,
    }
}
