//! A generated function: signature, doc comment, body and trait.
//!
//! In: a [`GeneratedFunction`] of a [`Module`]. Out: an inherent method, and the implementation of a trait that calls
//! it.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::arguments::{no_actions, type_of};
use super::body::{FunctionBody, Results, Returns, body};
use super::comments::doc;
use super::declaration;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{Lengths, known};
use super::library::Library;
use super::names::ident;
use super::results::{result_type, result_value};
use crate::function::Function;
use crate::module::{GeneratedFunction, Module, arguments};
use crate::print::Fields;
use crate::print::large::columns;
use crate::schedule::Meaning;
use crate::space::{Space, Spaces};

/// Code with the meanings of its names.
#[derive(Clone, Debug)]
pub struct Explained {
    /// Code.
    pub text: TokenStream,
    /// Names with their meanings, except fields and names of the language.
    pub meanings: Vec<(String, Meaning)>,
    /// True if the code reads fields of the robot.
    pub reads_robot: bool,
}

/// Body of a function with these fields, to be put between braces, with the meanings of its names.
pub(super) fn explained(
    (generated, fields): (&GeneratedFunction, Fields<'_>),
    module: &Module,
    dialect: &Dialect,
) -> Explained {
    let spaces = &module.spaces;
    let arguments = generated.arguments(spaces);
    let returns = match (&*generated.functions, columns(&generated.functions, spaces)) {
        ([only], _) if only.result().is_number() => Returns::Number,
        (_, Some(columns)) => Returns::Matrix(columns),
        (_, None) => Returns::Arrays,
    };
    let FunctionBody {
        statements,
        results,
        meanings,
        reads_robot,
    } = body(
        (&generated.program, module.length),
        (&arguments, returns),
        (fields, spaces),
        dialect,
    );
    let result = match results {
        Results::Filled(matrix) => matrix.into_token_stream(),
        Results::Numbers(numbers) => result_value(&generated.functions, spaces, &numbers, dialect),
    };
    Explained {
        text: quote! { #statements #result },
        meanings,
        reads_robot,
    }
}

/// Method of a function with this body, under a comment.
pub(super) fn method(
    (item, spaces): (&Item, &Spaces),
    (generated, about): (&GeneratedFunction, &[String]),
    name: &Ident,
    (computation, dialect): (&TokenStream, &Dialect),
) -> TokenStream {
    let about = doc(about);
    let visibility = &item.visibility;
    let lengths = known(spaces);
    let acted = spaces.actions() > 0;
    let signature = signature(name, (&generated.functions, acted), &lengths, &[], dialect);
    quote! {
        #about
        #[must_use]
        #visibility #signature { #computation }
    }
}

/// Implementation of a function's trait by the method `name`.
pub(super) fn in_trait(
    module: &Module,
    item: &Item,
    function: Function,
    name: &Ident,
    dialect: &Dialect,
) -> TokenStream {
    let arguments = names(function, dialect).into_iter();
    let lengths = known(&module.spaces);
    // Controllers for any robot pass no external wrenches.
    let acted = module.spaces.actions() > 0 && function.takes_actions();
    let actions = match &dialect.library {
        Library::Runtime(runtime) if acted => Some(no_actions(&lengths, runtime)),
        Library::Runtime(_) | Library::Core(_) | Library::Lanes(_) => None,
    };
    let arguments = arguments.map(ToTokens::into_token_stream).chain(actions);
    let call = quote! { Self::#name(self, #(#arguments),*) };
    implementation(item, function, &lengths, &[], &call, dialect)
}

/// Names of a function's arguments.
pub(super) fn names(function: Function, dialect: &Dialect) -> Vec<Ident> {
    let arguments = function.arguments().iter();
    arguments
        .map(|&argument| dialect.argument(argument))
        .collect()
}

/// Implementation of a function's trait with the given body, for arrays of the given lengths, some of which may be the
/// generic parameters `unknown`.
pub(super) fn implementation(
    item: &Item,
    function: Function,
    lengths: Lengths<'_>,
    unknown: &[TokenStream],
    call: &TokenStream,
    dialect: &Dialect,
) -> TokenStream {
    let Library::Runtime(runtime) = &dialect.library else {
        return TokenStream::new();
    };
    let of = of_runtime(function, lengths, runtime, dialect);
    let head = declaration::implementation(item, &of, &generics(unknown, dialect));
    let method = ident(function.name());
    let parameters = parameters((&[function], false), lengths, dialect);
    quote! { #head { #[inline] fn #method #parameters { #call } } }
}

/// Trait of a function for arrays of the given lengths.
pub(super) fn of_runtime(
    function: Function,
    lengths: Lengths<'_>,
    runtime: &TokenStream,
    dialect: &Dialect,
) -> TokenStream {
    let number = &dialect.number;
    // Traits have the names of the variants.
    let name = format_ident!("{function:?}");
    let [count, coordinates] = [Space::Velocities, Space::Coordinates].map(lengths);
    let same = count.to_string() == coordinates.to_string();
    let coordinates = (!same).then(|| quote! { , #coordinates });
    let further = function.further().into_iter().map(lengths);
    quote! { #runtime::robot::#name<#count, #(#further,)* #number #coordinates> }
}

/// `fn gravity<T: ::homogen::Scalar>(&self, q: &[T; 2]) -> [T; 2]` of functions with or without external wrenches;
/// `unknown` are generic parameters for lengths.
pub(super) fn signature(
    name: &Ident,
    functions: (&[Function], bool),
    lengths: Lengths<'_>,
    unknown: &[TokenStream],
    dialect: &Dialect,
) -> TokenStream {
    let generics = generics(unknown, dialect);
    let name = match &*generics {
        [] => quote! { #name },
        generics => quote! { #name<#(#generics),*> },
    };
    let parameters = parameters(functions, lengths, dialect);
    quote! { fn #name #parameters }
}

/// Generic parameters of a function.
pub(super) fn generics(unknown: &[TokenStream], dialect: &Dialect) -> Vec<TokenStream> {
    let bound = dialect.bound().into_iter();
    bound.chain(unknown.iter().cloned()).collect()
}

/// `(&self, q: &[T; 2]) -> [T; 2]`.
pub(super) fn parameters(
    (functions, acted): (&[Function], bool),
    lengths: Lengths<'_>,
    dialect: &Dialect,
) -> TokenStream {
    let parameters = arguments(functions, acted).into_iter().map(|argument| {
        let name = dialect.argument(argument);
        let of = type_of(argument, lengths, dialect);
        quote! { #name: &#of }
    });
    let result = result_type(functions, lengths, dialect);
    quote! { (&self, #(#parameters),*) -> #result }
}
