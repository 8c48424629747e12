//! A robot's description of itself as constants of its struct, and as the runtime's trait `Robot`.
//!
//! In: a [`Module`] and its struct. Out: a block of constants, and with the runtime an implementation of the trait.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::Visibility;

use super::chain::{chain_type, motion_of};
use super::comments::doc;
use super::declaration::{self, implementation};
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{Lengths, array, known, literal};
use super::library::Library;
use super::literals::Numerals;
use super::names::ident;
use crate::module::Module;
use crate::print::described::{CONFIGURATIONS, NumberList, limits, names, neutral, radii};
use crate::real::Real;
use crate::space::{Space, Spaces};

/// The constants, and the trait with the runtime.
pub(super) fn described(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let visibility = &item.visibility;
    let (text, whole) = match &dialect.library {
        Library::Runtime(_) => (
            quote! { ::core::primitive::str },
            quote! { ::core::primitive::usize },
        ),
        Library::Core(_) => (quote! { str }, quote! { usize }),
        // The package's class has them.
        Library::Lanes(_) => return TokenStream::new(),
    };
    let counts = [
        ("NQ", "Number of coordinates.", Space::Coordinates),
        ("NV", "Number of degrees of freedom.", Space::Velocities),
    ];
    let counts = counts.map(|(name, about, space)| {
        let (name, about) = (ident(name), doc(&[about]));
        let count = literal(module.spaces.len(space));
        quote! { #about #visibility const #name: #whole = #count; }
    });
    let names = names(module).into_iter().map(|list| {
        let (name, about) = (constant(list.name), doc(&[list.about]));
        let count = literal(list.names.len());
        let names = list.names.into_iter().map(string);
        quote! { #about #visibility const #name: [&'static #text; #count] = [#(#names),*]; }
    });
    let number = dialect.field();
    let all = numbers(module).into_iter().chain(radii(module));
    let numbers = all.map(|list| {
        let infinite = list.numbers.iter().any(|limit| limit.is_infinite());
        let missing = infinite.then_some("Infinite where the description has none.");
        let lines: Vec<&str> = [list.about].into_iter().chain(missing).collect();
        let (name, about) = (constant(list.name), doc(&lines));
        let of = array(&number, &literal(list.numbers.len()));
        let numbers = written(&list.numbers, dialect.real, &number);
        quote! { #about #visibility const #name: #of = #numbers; }
    });
    let configurations = (!module.configurations.is_empty()).then(|| {
        let about = doc(&[CONFIGURATIONS]);
        let count = literal(module.configurations.len());
        let of = array(&number, &literal(module.spaces.len(Space::Coordinates)));
        let list = configurations(module, dialect.real, &number);
        quote! { #about #visibility const CONFIGURATIONS: [(&'static #text, #of); #count] = #list; }
    });
    let constants = quote! { #(#counts)* #(#names)* #(#numbers)* #configurations };
    let block = declaration::block(item, &constants, dialect);
    let of_trait = in_trait(module, item, dialect);
    // A program need not read them all.
    quote! { #[allow(dead_code)] #block #of_trait }
}

/// Length of constants whose length is unknown.
const LONG: usize = 64;

/// The same constants without content, and the trait, for a robot whose description has errors: code that reads them
/// causes no further errors. An unknown length is a generic parameter of the trait, and of a constant long enough for
/// any index.
pub(super) fn absent(
    item: &Item,
    spaces: Option<&Spaces>,
    (lengths, parameter): (Lengths<'_>, Option<&TokenStream>),
    chain: &TokenStream,
    dialect: &Dialect,
) -> TokenStream {
    let Library::Runtime(runtime) = &dialect.library else {
        return TokenStream::new();
    };
    let text = quote! { &'static ::core::primitive::str };
    let lists = |visibility: Option<&Visibility>, number: &TokenStream, lengths: Lengths<'_>| {
        let [nq, nv] = [Space::Coordinates, Space::Velocities].map(lengths);
        quote! {
            #visibility const COORDINATES: [#text; #nq] = [""; #nq];
            #visibility const VELOCITIES: [#text; #nv] = [""; #nv];
            #visibility const LOWER: [#number; #nq] = [0.0; #nq];
            #visibility const UPPER: [#number; #nq] = [0.0; #nq];
            #visibility const MAX_VELOCITY: [#number; #nv] = [0.0; #nv];
            #visibility const MAX_EFFORT: [#number; #nv] = [0.0; #nv];
            #visibility const NEUTRAL: [#number; #nq] = [0.0; #nq];
        }
    };
    let own = |space: Space| literal(spaces.map_or(LONG, |spaces| spaces.len(space)));
    let [nq, nv] = [Space::Coordinates, Space::Velocities].map(own);
    let visibility = &item.visibility;
    let constants = lists(Some(visibility), &dialect.field(), &own);
    let constants = quote! {
        #visibility const NQ: ::core::primitive::usize = #nq;
        #visibility const NV: ::core::primitive::usize = #nv;
        #visibility const JOINTS: [#text; 0] = [];
        #visibility const FRAMES: [#text; 0] = [];
        #constants
    };
    let block = declaration::block(item, &constants, dialect);
    let [nq, nv] = [Space::Coordinates, Space::Velocities].map(lengths);
    let parameters: Vec<_> = parameter.into_iter().cloned().collect();
    let head = implementation(item, &quote! { #runtime::Robot<#nv, #nq> }, &parameters);
    let of_trait = lists(None, &quote! { ::core::primitive::f64 }, lengths);
    quote! {
        #block
        #head {
            type Chain = #chain;
            const JOINTS: &'static [#text] = &[];
            const MOTIONS: &'static [#runtime::Motion] = &[];
            const FRAMES: &'static [#text] = &[];
            #of_trait
        }
    }
}

/// All lists of numbers.
fn numbers(module: &Module) -> [NumberList; 5] {
    let [lower, upper, velocity, effort] = limits(module);
    [lower, upper, velocity, effort, neutral(module)]
}

/// The implementation of the trait, in `f64` whatever the robot's type of number.
fn in_trait(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let Library::Runtime(runtime) = &dialect.library else {
        return TokenStream::new();
    };
    let text = quote! { &'static ::core::primitive::str };
    let number = quote! { ::core::primitive::f64 };
    let [coordinates, velocities] =
        [Space::Coordinates, Space::Velocities].map(|space| literal(module.spaces.len(space)));
    let numbers = numbers(module).map(|list| {
        let name = constant(list.name);
        let of = array(&number, &literal(list.numbers.len()));
        let value = match dialect.real {
            Real::F32 => written(&list.numbers, Real::F64, &number),
            Real::F64 | Real::Generic => quote! { Self::#name },
        };
        quote! { const #name: #of = #value; }
    });
    let configurations = (!module.configurations.is_empty()).then(|| {
        let list = match dialect.real {
            Real::F32 => configurations(module, Real::F64, &number),
            Real::F64 | Real::Generic => quote! { Self::CONFIGURATIONS },
        };
        quote! {
            const CONFIGURATIONS: &'static [(#text, [#number; #coordinates])] = &#list;
        }
    });
    let chain = chain_type(
        &known(&module.spaces),
        &literal(module.data.names.len()),
        &literal(module.data.frames.len()),
        runtime,
    );
    let motions = module.data.motions.iter();
    let motions = motions.map(|&motion| motion_of(motion, runtime));
    let of = quote! { #runtime::Robot<#velocities, #coordinates> };
    let head = implementation(item, &of, &[]);
    // For other types the implementation refers to the constants and prints no literals.
    let allowed = (dialect.real == Real::F32).then(|| declaration::allowed(dialect));
    quote! {
        #allowed #head {
            type Chain = #chain;
            const JOINTS: &'static [#text] = &Self::JOINTS;
            const MOTIONS: &'static [#runtime::Motion] = &[#(#motions),*];
            const COORDINATES: [#text; #coordinates] = Self::COORDINATES;
            const VELOCITIES: [#text; #velocities] = Self::VELOCITIES;
            const FRAMES: &'static [#text] = &Self::FRAMES;
            #(#numbers)*
            #configurations
        }
    }
}

/// The configurations with names.
fn configurations(module: &Module, real: Real, number: &TokenStream) -> TokenStream {
    let configurations = module.configurations.iter().map(|configuration| {
        let name = string(&configuration.name);
        let q = written(&configuration.q, real, number);
        quote! { (#name, #q) }
    });
    quote! { [#(#configurations),*] }
}

/// A list of numbers of a type.
fn written(numbers: &[f64], real: Real, number: &TokenStream) -> TokenStream {
    let numbers = numbers.iter().map(|&limit| {
        if limit == f64::INFINITY {
            quote! { #number::INFINITY }
        } else if limit == f64::NEG_INFINITY {
            quote! { #number::NEG_INFINITY }
        } else {
            match real {
                Real::F32 => Numerals::Single.write(limit),
                Real::F64 | Real::Generic => Numerals::Bare.write(limit),
            }
        }
    });
    quote! { [#(#numbers),*] }
}

/// The name of a constant.
fn constant(name: &str) -> Ident {
    ident(&name.to_uppercase())
}

/// A string that has its letters whatever becomes of a file, such as one in ASCII.
fn string(text: &str) -> Literal {
    let escaped = format!("\"{}\"", text.escape_default());
    escaped.parse().unwrap_or_else(|_| Literal::string(text))
}
