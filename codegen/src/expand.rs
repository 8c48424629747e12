//! The six lines from a description to tokens.
//!
//! In: what a door has read. Out: what the last stage prints. It never does a stage's work.

use proc_macro2::TokenStream;

use crate::description::Description;
use crate::emit::{Item, Listing};
use crate::error::{Errors, Place};
use crate::request::Request;

/// A description and what is asked of it, as far as tokens.
///
/// # Errors
/// All the mistakes of the description and of the request.
pub fn expand(_: &Description, _: &Request, _: Item) -> Result<Listing, Errors> {
    Err(not_joined())
}

/// What `#[derive(Robot)]` adds to the struct in `input`.
#[must_use]
pub fn derive(_input: TokenStream) -> TokenStream {
    not_joined().to_compile_errors()
}

/// What `chain! { … }` expands to.
#[must_use]
pub fn chain(_input: TokenStream) -> TokenStream {
    not_joined().to_compile_errors()
}

fn not_joined() -> Errors {
    let mut errors = Errors::new();
    errors.push(Place::Unknown, "the stages are not joined yet");
    errors
}
