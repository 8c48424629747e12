//! Functions that are compiled for several kinds of processor, one of which is chosen when the program runs.
//!
//! In: a function with its equations. Out: a body that hands the equations to the runtime, generic over the rounding
//! of their products. The choice takes less than a nanosecond, so that almost every function gains.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{GenericParam, Generics, parse_quote};

use super::arguments::type_of;
use super::comments::doc;
use super::dialect::{Dialect, Equations};
use super::item::Item;
use super::lengths::known;
use super::library::Library;
use super::method::{self, Explained};
use super::results::result_type;
use crate::module::{GeneratedFunction, Module};
use crate::print::Fields;
use crate::schedule::OperationCount;

/// Argument of equations.
pub(super) struct EquationArgument {
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
    let inside = if gains(&generated.operation_count) {
        dialect.of_equations(module.reproducible)
    } else {
        dialect.clone()
    };
    let body = method::explained((generated, fields), module, &inside);
    let equations = with_packs(&body, module, &inside, || {
        method::explained((generated, fields), module, &inside.of_packs())
    });
    let lengths = known(&module.spaces);
    let result = result_type(&generated.functions, &lengths, &inside);
    let robot = body.reads_robot.then(|| robot(item, &inside));
    let arguments = generated.arguments(&module.spaces).into_iter();
    let arguments = arguments.map(|argument| {
        let name = inside.argument(argument).into_token_stream();
        let of = type_of(argument, &lengths, &inside);
        EquationArgument {
            value: name.clone(),
            name,
            of: quote! { &#of },
        }
    });
    let arguments: Vec<_> = robot.into_iter().chain(arguments).collect();
    // Every parameter must be named by an argument.
    let generics = if body.reads_robot {
        with_number(&item.generics, dialect)
    } else {
        with_number(&Generics::default(), dialect)
    };
    dispatched(
        (&arguments, &generics),
        (Some(&result), None),
        &equations,
        &inside,
    )
}

/// Equations of one state, beside those of packs of states if batches need them: a loop over limbs would move packs
/// through memory, and has nothing left to compute together.
fn with_packs(
    body: &Explained,
    module: &Module,
    dialect: &Dialect,
    in_packs: impl FnOnce() -> Explained,
) -> TokenStream {
    let (one, number) = (&body.text, &dialect.number);
    let Library::Runtime(runtime) = &dialect.library else {
        return one.clone();
    };
    if !module.batch || module.spaces.limbs.is_empty() {
        return one.clone();
    }
    let several = in_packs().text;
    if several.to_string() == one.to_string() {
        return several;
    }
    quote! { if <#number as #runtime::Scalar>::IS_PACK { #several } else { #one } }
}

/// Minimum number of products and sums without any fused one for which a choice gains.
const LEAST: usize = 20;

/// True if a choice of the processor gains: if a product is fused with a sum, which sines do as well, or if there are
/// many. Otherwise the choice, 0.8 ns, would double the time of constant results and of single sums.
fn gains(count: &OperationCount) -> bool {
    count.fused + count.sin + count.cos > 0 || count.mul + count.add >= LEAST
}

/// The robot as an argument of equations.
pub(super) fn robot(item: &Item, inside: &Dialect) -> EquationArgument {
    let (_, own, _) = item.generics.split_for_impl();
    let robot = &item.ident;
    EquationArgument {
        name: inside.this(),
        value: quote! { self },
        of: quote! { &#robot #own },
    }
}

/// Generic parameters with the type of numbers, unless it is one of them or is known.
pub(super) fn with_number(generics: &Generics, dialect: &Dialect) -> Generics {
    let mut generics = generics.clone();
    let is_new = generics.params.is_empty();
    let bound = if is_new {
        dialect.bound_inside()
    } else {
        dialect.bound()
    };
    let bound = bound.map(|bound| -> GenericParam {
        parse_quote! { #bound }
    });
    generics.params.extend(bound);
    generics
}

/// Statements that choose the processor and compute, with the result; in other dialects the equations themselves.
///
/// `read` is a number of the work, `self.0[0]`, if it is compiled in a function of its own where numbers are registers.
pub(super) fn dispatched(
    (arguments, generics): (&[EquationArgument], &Generics),
    (result, read): (Option<&TokenStream>, Option<&TokenStream>),
    equations: &TokenStream,
    dialect: &Dialect,
) -> TokenStream {
    let (Library::Runtime(runtime), Some(names)) = (&dialect.library, &dialect.equations) else {
        return equations.clone();
    };
    let Equations { name, rounding, .. } = names;
    let reproducible = names.reproducible.then(|| {
        quote! { const REPRODUCIBLE: ::core::primitive::bool = true; }
    });
    let about = "Compiled for several kinds of processor, one of which is chosen at run time.";
    let about = doc(&[about.to_owned()]);
    let (parameters, _, bounds) = generics.split_for_impl();
    let types = together(arguments.iter().map(|argument| &argument.of));
    let names = together(arguments.iter().map(|argument| &argument.name));
    let values = together(arguments.iter().map(|argument| &argument.value));
    let returned = result.map(|result| quote! { -> #result });
    let result = result.map_or_else(|| quote! { () }, Clone::clone);
    let number = &dialect.number;
    let read = read.map(|read| {
        quote! {
            #[inline(always)]
            fn number(&self) -> ::core::option::Option<#number> { ::core::option::Option::Some(#read) }
        }
    });
    quote! {
        #about
        struct #name<A>(A);
        impl #parameters #runtime::dispatch::Work<#number> for #name<#types> #bounds {
            type Output = #result;
            #reproducible
            #read
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
