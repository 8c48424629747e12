//! Functions for C around the methods.
//!
//! In: a [`Module`] and its struct. Out: a function with C's calling convention for each method, and the header that
//! declares them. Pointers are references to arrays of fixed size, and results may be uninitialised memory. The only
//! unsafe attribute states that the names are unique.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::ext::IdentExt;

use super::arguments;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{array, known, literal};
use super::library::{CoreFunctions, Library};
use super::names::{ident, of_methods};
use super::results::type_of;
use crate::module::{GeneratedFunction, Module};
use crate::print::c;
use crate::print::steps::ConfigurationFunction;

/// The functions, one for each method, if the library has a prefix for them.
pub(super) fn functions(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let Library::Core(CoreFunctions {
        c_prefix: Some(prefix),
        ..
    }) = &dialect.library
    else {
        return TokenStream::new();
    };
    let methods = module.functions.iter().zip(of_methods(module));
    methods
        .zip(c::symbols(module, prefix))
        .map(|((generated, method), symbol)| {
            function(module, item, generated, &method, &symbol, dialect)
        })
        .chain(
            ConfigurationFunction::of(module)
                .iter()
                .map(|&step| of_step(step, module, prefix, item, dialect)),
        )
        .collect()
}

/// The function of a method of configurations.
fn of_step(
    step: ConfigurationFunction,
    module: &Module,
    prefix: &str,
    item: &Item,
    dialect: &Dialect,
) -> TokenStream {
    let row = |space| array(&dialect.number, &literal(module.spaces.len(space)));
    let (arguments, types): (Vec<Ident>, Vec<_>) = (step.arguments().iter())
        .map(|&(name, space)| (dialect.local(name), row(space)))
        .unzip();
    let (receiver, value) = receiver(module, item, dialect);
    let method = ident(step.name());
    let result = dialect.local(step.name());
    let types = quote! { #receiver #(#arguments: &#types,)* };
    let returned = row(step.result());
    let body = quote! { #result.write(#value.#method(#(#arguments),*)); };
    for_c(
        (item, &method),
        &c::own(prefix, step.name()),
        &quote! { #types #result: &mut ::core::mem::MaybeUninit<#returned>, },
        &body,
    )
}

/// Parameter for the robot if it has fields, and the expression that reads it.
fn receiver(module: &Module, item: &Item, dialect: &Dialect) -> (TokenStream, TokenStream) {
    let robot = &item.ident;
    if module.parameters.is_empty() {
        (TokenStream::new(), quote! { #robot })
    } else {
        let value = dialect.local("robot");
        (quote! { #value: &#robot, }, quote! { #value })
    }
}

/// Function for C around a method.
fn for_c(
    (item, method): (&Item, &Ident),
    symbol: &str,
    parameters: &TokenStream,
    body: &TokenStream,
) -> TokenStream {
    let robot = &item.ident;
    let about = format!(" [`{robot}::{method}`] for C; its header documents the pointers.");
    let name = ident(symbol);
    quote! {
        #[doc = #about]
        #[allow(unsafe_code, reason = "the name must be unique in the linked program")]
        #[unsafe(no_mangle)]
        pub extern "C" fn #name(#parameters) {
            #body
        }
    }
}

/// The header that declares them.
#[must_use]
pub fn c_header(
    module: &Module,
    item: &Item,
    asked: &str,
    core_functions: &CoreFunctions,
) -> Option<String> {
    let prefix = core_functions.c_prefix.as_deref()?;
    let header = c::Header {
        prefix,
        guard: &format!("{prefix}{}_", item.ident.unraw()),
        asked,
        angles: &core_functions.angles(module.scalar),
        needs: None,
        steps: None,
    };
    Some(header.text(module))
}

fn function(
    module: &Module,
    item: &Item,
    generated: &GeneratedFunction,
    method: &Ident,
    symbol: &str,
    dialect: &Dialect,
) -> TokenStream {
    let lengths = known(&module.spaces);
    let arguments = generated.arguments(&module.spaces);
    let each = arguments.iter();
    let each = each.map(|&argument| arguments::type_of(argument, &lengths, dialect));
    let each: Vec<_> = each.collect();
    let arguments: Vec<_> = arguments
        .iter()
        .map(|&argument| dialect.argument(argument))
        .collect();
    let results = c::results(&generated.functions);
    let types = results
        .iter()
        .map(|(_, quantity)| type_of(quantity, &lengths, dialect));
    let results: Vec<_> = results
        .iter()
        .map(|(name, _)| dialect.local(name))
        .collect();

    let (receiver, value) = receiver(module, item, dialect);
    let call = quote! { #value.#method(#(#arguments),*) };
    // Several functions return a tuple, several quantities of one function a struct.
    let values: Vec<_> = generated
        .functions
        .iter()
        .map(|function| dialect.local(&format!("{}_", function.name())))
        .collect();
    let pattern = match &*values {
        [value] => quote! { #value },
        values => quote! { (#(#values),*) },
    };
    let parts = generated
        .functions
        .iter()
        .zip(&values)
        .flat_map(|(function, value)| {
            function.result().parts().map(move |(part, _)| {
                let part = part.map(ident);
                let part = part.map(|part| quote! { .#part });
                quote! { #value #part }
            })
        });
    let body = if let ([result], [_]) = (&*results, &*generated.functions) {
        quote! { #result.write(#call); }
    } else {
        quote! {
            let #pattern = #call;
            #(#results.write(#parts);)*
        }
    };
    let parameters = quote! {
        #receiver
        #(#arguments: &#each,)*
        #(#results: &mut ::core::mem::MaybeUninit<#types>,)*
    };
    for_c((item, method), symbol, &parameters, &body)
}
