//! Functions that are compiled for several kinds of processor, one of which is chosen when the program runs.
//!
//! In: a function with its equations. Out: a body that hands the equations to the runtime, generic over the rounding
//! of their products. Short functions are compiled for the target alone.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{GenericParam, Generics, parse_quote};

use super::arguments::type_of;
use super::comments::doc;
use super::dialect::{Dialect, Equations};
use super::item::Item;
use super::lengths::known;
use super::method;
use super::results::result_type;
use super::world::World;
use crate::module::{GeneratedFunction, Module};
use crate::print::Fields;
use crate::schedule::Price;

/// Minimum number of products, sums, quotients and roots of a function that is compiled for several kinds of processor.
const LEAST: usize = 150;

/// Argument of equations.
pub(super) struct Argument {
    /// Its name in the equations.
    pub name: TokenStream,
    /// Its value where they are called.
    pub value: TokenStream,
    /// Its type.
    pub of: TokenStream,
}

/// Body of a function with these fields, to be put between braces.
pub(super) fn computation(
    (generated, fields): (&GeneratedFunction, Fields<'_>),
    module: &Module,
    item: &Item,
    dialect: &Dialect,
) -> TokenStream {
    let inside = match &dialect.world {
        World::Runtime(_) if is_long(&generated.price) => dialect.of_equations(),
        World::Runtime(_) | World::Core(_) | World::Lanes(_) => {
            return method::computation((generated, fields), module, dialect);
        }
    };
    let body = method::explained((generated, fields), module, &inside);
    let lengths = known(&module.spaces);
    let result = result_type(&generated.functions, &lengths, &inside);
    let (_, own, _) = item.generics.split_for_impl();
    let robot = &item.ident;
    let robot = body.reads_robot.then(|| Argument {
        name: inside.this(),
        value: quote! { self },
        of: quote! { &#robot #own },
    });
    let arguments = generated.arguments(&module.spaces).into_iter();
    let arguments = arguments.map(|argument| {
        let name = inside.argument(argument).into_token_stream();
        let of = type_of(argument, &lengths, &inside);
        Argument {
            value: name.clone(),
            name,
            of: quote! { &#of },
        }
    });
    let arguments: Vec<_> = robot.into_iter().chain(arguments).collect();
    // Every parameter must be named by an argument.
    let (mut generics, bound) = if body.reads_robot {
        (item.generics.clone(), dialect.bound())
    } else {
        (Generics::default(), dialect.bound_inside())
    };
    let bound = bound.map(|bound| -> GenericParam { parse_quote! { #bound } });
    generics.params.extend(bound);
    dispatched((&arguments, &generics), Some(&result), &body.text, &inside)
}

/// True if a function is long enough to gain by the choice, which takes 2 ns.
fn is_long(price: &Price) -> bool {
    price.mul + price.add + price.div + price.sqrt >= LEAST
}

/// Statements that choose the processor and compute, with the result; in other dialects the equations themselves.
pub(super) fn dispatched(
    (arguments, generics): (&[Argument], &Generics),
    result: Option<&TokenStream>,
    equations: &TokenStream,
    dialect: &Dialect,
) -> TokenStream {
    let (World::Runtime(runtime), Some(Equations { name, rounding, .. })) =
        (&dialect.world, &dialect.equations)
    else {
        return equations.clone();
    };
    let about = "Compiled for several kinds of processor, one of which is chosen at run time.";
    let about = doc(&[about.to_owned()]);
    let (parameters, _, bounds) = generics.split_for_impl();
    let types = together(arguments.iter().map(|argument| &argument.of));
    let names = together(arguments.iter().map(|argument| &argument.name));
    let values = together(arguments.iter().map(|argument| &argument.value));
    let returned = result.map(|result| quote! { -> #result });
    let result = result.map_or_else(|| quote! { () }, Clone::clone);
    let number = &dialect.number;
    quote! {
        #about
        struct #name<A>(A);
        impl #parameters #runtime::dispatch::Work for #name<#types> #bounds {
            type Output = #result;
            #[inline(always)]
            fn run<#rounding: #runtime::rounding::Rounding>(self) #returned {
                let Self(#names) = self;
                #equations
            }
        }
        <#number as #runtime::Scalar>::dispatch(#name(#values))
    }
}

/// A tuple, or its only element.
fn together<'a>(parts: impl ExactSizeIterator<Item = &'a TokenStream>) -> TokenStream {
    if parts.len() == 1 {
        quote! { #(#parts)* }
    } else {
        quote! { (#(#parts),*) }
    }
}
