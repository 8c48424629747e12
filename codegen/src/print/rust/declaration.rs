//! Declaration of the struct, and heads of its blocks.
//!
//! In: an [`Item`] and its robot. Out: the declaration if it has to be printed, the block of its methods, and the heads
//! of implementations.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{GenericParam, parse_quote};

use super::comments::doc;
use super::dialect::Dialect;
use super::item::{Declaration, Item};
use super::lengths::{array, literal};
use super::library::Library;
use crate::module::Module;
use crate::print::documentation;

/// The struct, if it has to be printed.
pub(super) fn declaration(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    match &item.declaration {
        Declaration::Exists => TokenStream::new(),
        Declaration::Written(tokens) => tokens.clone(),
        Declaration::Made => made(module, item, dialect),
    }
}

fn made(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let Item {
        visibility, ident, ..
    } = item;
    let about = doc(&documentation::of_robot(module, ""));
    let derive = match dialect.library {
        Library::Runtime(_) => quote! {
            #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        },
        Library::Core(_) | Library::Lanes(_) => quote! { #[derive(Clone, Copy, Debug)] },
    };
    let number = dialect.field();
    let fields = module.parameters.iter().map(|parameter| {
        let field = &parameter.field;
        let about = doc(&[documentation::of_field(&parameter.target)]);
        let kind = match (&dialect.library, parameter.target.entries()) {
            (Library::Runtime(runtime), _) if parameter.target.is_payload() => {
                quote! { #runtime::Payload<#number> }
            }
            (_, 1) => number.clone(),
            (_, entries) => array(&number, &literal(entries)),
        };
        quote! { #about pub #field: #kind, }
    });
    let layout = dialect.is_for_c().then(|| quote! { #[repr(C)] });
    if module.parameters.is_empty() {
        quote! { #about #derive #visibility struct #ident; }
    } else {
        quote! { #about #derive #layout #visibility struct #ident { #(#fields)* } }
    }
}

/// The block of inherent methods.
pub(super) fn block(item: &Item, methods: &TokenStream, dialect: &Dialect) -> TokenStream {
    let ident = &item.ident;
    let (generics, arguments, bounds) = item.generics.split_for_impl();
    let allowed = allowed(dialect);
    quote! { #allowed impl #generics #ident #arguments #bounds { #methods } }
}

/// Lints that generated code does not follow.
pub(super) fn allowed(dialect: &Dialect) -> TokenStream {
    // Compilers before 1.81 reject reasons, and code for `core` alone supports these.
    let (inlined, reason) = match dialect.library {
        Library::Runtime(_) => (
            quote! { clippy::inline_always, },
            quote! { reason = "generated code has one form for every robot" },
        ),
        Library::Core(_) | Library::Lanes(_) => <(TokenStream, TokenStream)>::default(),
    };
    quote! {
        #[allow(
            clippy::approx_constant,
            #inlined
            clippy::large_stack_arrays,
            clippy::possible_missing_comma,
            clippy::similar_names,
            clippy::too_many_arguments,
            clippy::too_many_lines,
            clippy::trivially_copy_pass_by_ref,
            clippy::unreadable_literal,
            clippy::unused_self,
            #reason
        )]
    }
}

/// Head of an implementation of a trait, up to its brace.
pub(super) fn implementation(item: &Item, of: &TokenStream, more: &[TokenStream]) -> TokenStream {
    let ident = &item.ident;
    let (_, arguments, bounds) = item.generics.split_for_impl();
    let mut generics = item.generics.clone();
    let more = more.iter().map(|parameter| -> GenericParam {
        parse_quote! { #parameter }
    });
    generics.params.extend(more);
    let (generics, _, _) = generics.split_for_impl();
    quote! { #[automatically_derived] impl #generics #of for #ident #arguments #bounds }
}
