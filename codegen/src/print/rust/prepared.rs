//! Prepared robots.
//!
//! In: the prepared functions of a [`Module`]. Out: the method `prepare`, which computes everything that depends on
//! fields alone, and the struct of its results, with a method and a trait for each function.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::ext::IdentExt;
use syn::{Generics, parse_quote};

use super::body::{FunctionBody, Returns, VALUES, body};
use super::comments::doc;
use super::declaration;
use super::dialect::Dialect;
use super::dispatch;
use super::item::{Declaration, Item};
use super::lengths::{array, literal};
use super::library::Library;
use super::method;
use super::names::{ident, of_methods};
use super::steps;
use crate::module::Module;
use crate::print::{Fields, documentation};
use crate::space::Order;

/// Method of the robot, and items beside it; empty if it was not requested.
pub(super) fn prepared(
    module: &Module,
    item: &Item,
    dialect: &Dialect,
) -> (TokenStream, TokenStream) {
    let Some(prepared) = &module.prepared else {
        return <(TokenStream, TokenStream)>::default();
    };
    let own = of(item, dialect);
    let inside = dialect.of_equations(module.reproducible);
    let FunctionBody {
        statements,
        results,
        ..
    } = body(
        (&prepared.once, module.length),
        (&[], Returns::Arrays),
        (Fields::Own(&module.parameters), &module.spaces),
        &inside,
    );
    let results = results.numbers();
    let (values, visibility) = (ident(VALUES), &item.visibility);
    let name = &own.ident;
    let about = doc(&documentation::of_prepare(&prepared.operation_count));
    let signature = signature(item, dialect);
    let (_, arguments, _) = own.generics.split_for_impl();
    let generics = dispatch::with_number(&item.generics, dialect);
    let computation = dispatch::dispatched(
        (&[dispatch::robot(item, &inside)], &generics),
        (Some(&quote! { #name #arguments }), None),
        &quote! { #statements #name { #values: [#(#results),*] } },
        &inside,
    );
    let prepare = quote! {
        #about
        #[must_use]
        #visibility #signature { #computation }
    };

    let inside = dialect.of_prepared();
    let mut methods = TokenStream::new();
    let mut beside = TokenStream::new();
    for (generated, name) in prepared.functions.iter().zip(of_methods(module)) {
        let fields = Fields::Computed(&prepared.names);
        let body = dispatch::computation((generated, fields), module, &own, &inside);
        let about = documentation::of_function(
            module,
            generated,
            inside
                .angles()
                .as_ref()
                .map(|angles| (angles, Order::AngularFirst)),
            Some(&prepared.operation_count),
        );
        methods.extend(method::method(
            (&own, &module.spaces),
            (generated, &about),
            &name,
            (&body, &inside),
        ));
        if let ([function], None) = (&*generated.functions, &generated.frame) {
            beside.extend(method::in_trait(module, &own, *function, &name, &inside));
        }
    }
    methods.extend(steps::steps(module, &own, &inside));
    let methods = declaration::block(&own, &methods, &inside);
    let structure = structure(item, &own, prepared.names.len(), dialect);
    (prepare, quote! { #structure #methods #beside })
}

/// `fn prepare<T: ::homogen::Scalar>(&self) -> ArmPrepared<T>`.
fn signature(item: &Item, dialect: &Dialect) -> TokenStream {
    let own = of(item, dialect);
    let name = &own.ident;
    let (_, arguments, _) = own.generics.split_for_impl();
    let generics = dialect.bound().map(|bound| quote! { <#bound> });
    quote! { fn prepare #generics(&self) -> #name #arguments }
}

/// The struct of a prepared robot.
fn of(item: &Item, dialect: &Dialect) -> Item {
    let generics = dialect
        .bound()
        .map_or_else(Generics::default, |bound| parse_quote! { <#bound> });
    Item {
        visibility: item.visibility.clone(),
        ident: format_ident!("{}Prepared", item.ident.unraw(), span = item.ident.span()),
        generics,
        declaration: Declaration::Made,
    }
}

/// Its declaration with this number of values.
fn structure(item: &Item, own: &Item, count: usize, dialect: &Dialect) -> TokenStream {
    let about = doc(&documentation::of_prepared(&item.ident.unraw().to_string()));
    let derive = match dialect.library {
        Library::Runtime(_) => quote! {
            #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
        },
        Library::Core(_) | Library::Lanes(_) => quote! { #[derive(Clone, Copy, Debug)] },
    };
    let (name, visibility, values) = (&own.ident, &own.visibility, ident(VALUES));
    let (_, arguments, _) = own.generics.split_for_impl();
    let kind = array(&dialect.number, &literal(count));
    quote! { #about #derive #visibility struct #name #arguments { #values: #kind, } }
}

/// Signature of the method, and the struct, after an error, so that the rest of the program type-checks; `members` are
/// the methods and the traits of any struct of the robot.
pub(super) fn absent(
    item: &Item,
    dialect: &Dialect,
    members: impl Fn(&Item, &Dialect) -> (TokenStream, TokenStream),
) -> (TokenStream, TokenStream) {
    let own = of(item, dialect);
    let inside = dialect.of_prepared();
    let (methods, traits) = members(&own, &inside);
    let methods = declaration::block(&own, &methods, &inside);
    let structure = structure(item, &own, 0, dialect);
    (
        signature(item, dialect),
        quote! { #structure #methods #traits },
    )
}
