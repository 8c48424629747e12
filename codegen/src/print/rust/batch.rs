//! Functions of slices of states.
//!
//! In: a function of a robot. Out: the method for slices, `gravity_batch` beside `gravity`, which calls the runtime,
//! and the function's trait with the computation, which is inlined for vectors of states. The method for a single state
//! calls the trait as well, so that the computation is compiled once.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::comments::doc;
use super::declaration;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{Lengths, known};
use super::library::Library;
use super::method;
use super::names::ident;
use super::results::result_type;
use crate::function::Function;
use crate::module::Module;

/// Implementation of the runtime's trait of robots in batches by the inlined functions, if the runtime is available.
pub(super) fn robot(item: &Item, inlined: &[Function], dialect: &Dialect) -> TokenStream {
    let Library::Runtime(runtime) = &dialect.library else {
        return TokenStream::new();
    };
    let head = declaration::implementation(item, &quote! { #runtime::robot::Batched }, &[]);
    let names = inlined.iter().map(|function| function.name());
    let list = (!inlined.is_empty()).then(|| {
        quote! { const INLINED: &'static [&'static ::core::primitive::str] = &[#(#names),*]; }
    });
    quote! { #head { #list } }
}

/// A function of a robot, with the path of the runtime.
pub(super) struct Batched<'p> {
    module: &'p Module,
    item: &'p Item,
    function: Function,
    runtime: &'p TokenStream,
    dialect: &'p Dialect,
}

impl<'p> Batched<'p> {
    pub(super) fn new(
        module: &'p Module,
        item: &'p Item,
        function: Function,
        runtime: &'p TokenStream,
        dialect: &'p Dialect,
    ) -> Self {
        Self {
            module,
            item,
            function,
            runtime,
            dialect,
        }
    }

    /// Call of the function for one state, by its trait.
    pub(super) fn call(&self) -> TokenStream {
        let lengths = known(&self.module.spaces);
        let of = method::of_runtime(self.function, &lengths, self.runtime, self.dialect);
        let (name, arguments) = (
            ident(self.function.name()),
            method::names(self.function, self.dialect),
        );
        quote! { <Self as #of>::#name(self, #(#arguments),*) }
    }

    /// The function's trait with the computation.
    pub(super) fn in_trait(&self, body: &TokenStream) -> TokenStream {
        let lengths = known(&self.module.spaces);
        let of = method::of_runtime(self.function, &lengths, self.runtime, self.dialect);
        let generics = method::generics(&[], self.dialect);
        let head = declaration::implementation(self.item, &of, &generics);
        let name = ident(self.function.name());
        let parameters = method::parameters((&[self.function], false), &lengths, self.dialect);
        let allowed = declaration::allowed(self.dialect);
        quote! {
            #allowed
            #head {
                #[allow(clippy::inline_always, reason = "what is inlined is compiled for the caller's vectors")]
                #[inline(always)]
                fn #name #parameters { #body }
            }
        }
    }

    /// The method for slices of states.
    pub(super) fn method(&self) -> TokenStream {
        let lengths = known(&self.module.spaces);
        let runtime = self.runtime;
        let results = self.dialect.local("results");
        let (name, arguments) = (
            ident(self.function.name()),
            method::names(self.function, self.dialect),
        );
        let visibility = &self.item.visibility;
        let signature = signature(self.function, (&lengths, &[]), runtime, self.dialect);
        let about = doc(&[
            format!(
                "[`{name}`](Self::{name}) of each state in slices, into `{results}`, with the same bits."
            ),
            String::new(),
            "Computes as many states at a time as the processor's vectors have lanes.".to_owned(),
            String::new(),
            "# Errors".to_owned(),
            String::new(),
            "If a slice is not as long as `q`; then nothing is written.".to_owned(),
        ]);
        quote! {
            #about
            #visibility #signature {
                #runtime::batch::Batch::of(self).#name(#(#arguments,)* #results)
            }
        }
    }
}

/// `fn gravity_batch<T: ::homogen::batch::Number>(&self, q: &[[T; 2]], results: &mut [[T; 2]]) -> …`, for arrays of
/// the given lengths, some of which may be generic parameters.
pub(super) fn signature(
    function: Function,
    (lengths, unknown): (Lengths<'_>, &[TokenStream]),
    runtime: &TokenStream,
    dialect: &Dialect,
) -> TokenStream {
    let number = &dialect.number;
    let name = format_ident!("{}_batch", function.name());
    let parameters = function.arguments().iter().map(|argument| {
        let name: Ident = dialect.argument(*argument);
        let length = lengths(argument.space());
        quote! { #name: &[[#number; #length]] }
    });
    let result = result_type(&[function], lengths, dialect);
    let results = dialect.local("results");
    quote! {
        fn #name<#number: #runtime::batch::Number #(, #unknown)*>(
            &self,
            #(#parameters,)*
            #results: &mut [#result],
        ) -> ::core::result::Result<(), #runtime::batch::BatchError>
        where
            Self: ::core::marker::Sync,
    }
}
