//! Values of the base parameters.
//!
//! In: a [`Module`]. Out: the constant `BASE_PARAMETERS`, if the base regressor is among its functions.

use proc_macro2::TokenStream;
use quote::quote;

use super::comments::doc;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{array, literal};
use super::literals::Numerals;
use crate::module::Module;
use crate::print::documentation;
use crate::real::Real;

/// `pub const BASE_PARAMETERS: [f64; NB] = […];`
pub(super) fn base_parameters(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let Some(values) = module.base_parameters() else {
        return TokenStream::new();
    };
    let numerals = match dialect.real {
        Real::F32 => Numerals::Single,
        Real::F64 | Real::Generic => Numerals::Bare,
    };
    let numbers = values.iter().map(|&value| numerals.write(value));
    let of = array(&dialect.field(), &literal(values.len()));
    let about = doc(&documentation::of_base_parameters(module));
    let visibility = &item.visibility;
    quote! { #about #visibility const BASE_PARAMETERS: #of = [#(#numbers),*]; }
}
