//! The doors for the compiler: parse, delegate, convert.
//!
//! Everything is in `homogen-codegen`, which knows nothing of `proc_macro`; the macros are
//! documented where users meet them, in `homogen`.

use proc_macro::TokenStream;

/// Adds the functions of a robot to a struct, as methods and as traits.
#[proc_macro_derive(Robot, attributes(robot))]
pub fn derive(input: TokenStream) -> TokenStream {
    homogen_codegen::door::derive(input.into()).into()
}

/// Describes a robot in place, and declares the struct that has its functions.
#[proc_macro]
pub fn chain(input: TokenStream) -> TokenStream {
    homogen_codegen::door::chain(input.into()).into()
}
