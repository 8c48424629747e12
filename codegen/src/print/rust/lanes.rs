//! Functions of several states in the lanes of vectors.
//!
//! In: a [`Module`], the struct that gets methods, and the path of a crate with a trait `number::Number`. Out: the
//! struct, and a method for each function on flat arrays of numbers. Documentation is printed where the functions are
//! called from.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::body::{FunctionBody, Returns, body};
use super::comments::doc;
use super::declaration;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::literal;
use super::library::Library;
use super::names::of_methods;
use super::steps;
use crate::module::{GeneratedFunction, Module};
use crate::print::{Fields, c, documentation};
use crate::schedule::Length;

/// The struct and its methods.
#[must_use]
pub fn lanes(module: &Module, item: &Item, path: &TokenStream) -> TokenStream {
    let dialect = Dialect::of(
        module.scalar,
        module.sines,
        item,
        &Library::Lanes(path.clone()),
    );
    let methods = module.functions.iter().zip(of_methods(module));
    let methods = methods.map(|(generated, name)| method(module, item, generated, &name, &dialect));
    let mut methods: TokenStream = methods.collect();
    methods.extend(steps::steps(module, item, &dialect));
    let declaration = declaration::declaration(module, item, &dialect);
    let block = declaration::block(item, &methods, &dialect);
    quote! { #declaration #block }
}

fn method(
    module: &Module,
    item: &Item,
    generated: &GeneratedFunction,
    name: &Ident,
    dialect: &Dialect,
) -> TokenStream {
    let Library::Lanes(path) = &dialect.library else {
        return TokenStream::new();
    };
    let arguments = generated.arguments(&module.spaces);
    let FunctionBody {
        statements,
        results,
        ..
    } = body(
        (&generated.program, Length::UNBOUNDED),
        (&arguments, Returns::Arrays),
        (Fields::Own(&module.parameters), &module.spaces),
        dialect,
    );
    let results = results.numbers();
    let number = &dialect.number;
    let parameters = arguments.iter().map(|argument| {
        let length = literal(module.spaces.len(argument.space()));
        let argument = dialect.argument(*argument);
        quote! { #argument: &[#number; #length] }
    });
    let first = arguments
        .first()
        .map(|&argument| dialect.argument(argument));
    let constant = |value: f64| {
        let value = Literal::f64_unsuffixed(value);
        quote! { #path::number::Number::like(#first[0], #value) }
    };
    let mut rest = &*results;
    let quantities = c::results(&generated.functions);
    let (types, values): (Vec<_>, Vec<_>) = quantities
        .iter()
        .map(|(_, quantity)| {
            let size = quantity.size(&module.spaces);
            let (own, others) = rest.split_at(size.min(rest.len()));
            rest = others;
            let last = quantity.entity.fourth_row().into_iter().flatten();
            let last: Vec<_> = last.map(constant).collect();
            let whole = own.chunks(quantity.entity.size());
            let whole: Vec<_> = whole
                .flat_map(|entity| entity.iter().chain(&last))
                .collect();
            let size = literal(whole.len());
            (quote! { [#number; #size] }, quote! { [#(#whole),*] })
        })
        .unzip();
    let bound = dialect.bound();
    let about = doc(&[documentation::title(module, generated)]);
    let visibility = &item.visibility;
    quote! {
        #about
        #[inline(always)]
        #visibility fn #name<#bound>(&self, #(#parameters),*) -> (#(#types,)*) {
            #statements
            (#(#values,)*)
        }
    }
}
