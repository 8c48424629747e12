//! Types of arguments, and patterns that destructure them.
//!
//! In: arguments, their lengths, and the names of the entries that are read. Out: types and statements.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

use super::dialect::Dialect;
use super::lengths::{Lengths, array, literal};
use super::library::Library;
use super::names::ident;
use crate::schedule::Entries;
use crate::space::{ACTION, Variable};

/// Type of an argument behind its reference: `[T; 6]`, `[::homogen::Action<T>; 2]`.
pub(super) fn type_of(argument: Variable, lengths: Lengths<'_>, dialect: &Dialect) -> TokenStream {
    let number = &dialect.number;
    let one = match (argument, &dialect.library) {
        (Variable::Actions, Library::Runtime(runtime)) => quote! { #runtime::Action<#number> },
        (Variable::Actions, Library::Core(_) | Library::Lanes(_)) => {
            array(number, &literal(ACTION.len()))
        }
        _ => number.clone(),
    };
    array(&one, &lengths(argument.space()))
}

/// `let [q_1, _, q_3] = *q;`, or `let _ = q;` if no entry is read.
pub(super) fn unpack((argument, entries): &(Variable, Entries), dialect: &Dialect) -> TokenStream {
    let name = dialect.argument(*argument);
    if entries.iter().all(Option::is_none) {
        return quote! { let _ = #name; };
    }
    let entries: Vec<TokenStream> = entries.iter().map(Option::as_ref).map(pattern).collect();
    if *argument != Variable::Actions || matches!(dialect.library, Library::Lanes(_)) {
        return quote! { let [#(#entries),*] = *#name; };
    }
    let actions = entries.chunks(ACTION.len());
    match &dialect.library {
        Library::Core(_) | Library::Lanes(_) => {
            let actions = actions.map(|entries| quote! { [#(#entries),*] });
            quote! { let [#(#actions),*] = *#name; }
        }
        Library::Runtime(_) => {
            let actions = actions.map(|entries| {
                let (c, f) = entries.split_at(3);
                quote! { ([#(#c),*], [#(#f),*]) }
            });
            let action = dialect.local("action");
            quote! { let [#(#actions),*] = #name.map(|#action| (#action.c(), #action.f())); }
        }
    }
}

/// Argument without external wrenches.
pub(super) fn no_actions(lengths: Lengths<'_>, runtime: &TokenStream) -> TokenStream {
    let length = lengths(Variable::Actions.space());
    quote! { &[#runtime::Action::zero(); #length] }
}

/// Pattern for a value; `_` without a name.
pub(super) fn pattern(name: Option<&String>) -> TokenStream {
    name.map_or_else(|| quote! { _ }, |name| ident(name).into_token_stream())
}
