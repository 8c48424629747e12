//! Sections of a long routine in Rust.
//!
//! In: the [`Work`] of a routine. Out: a function for each section, within its caller, and the calls. Indices of the
//! work array are literals below its length, so that none can fail.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::body::Writer;
use super::lengths::{array, literal};
use super::names::ident;
use crate::schedule::{Apart, LONGEST_SCOPE, Value, Work};

impl Writer<'_> {
    /// The functions; `constant` and `mul_add` are statements that bind the functions for literals and fused products.
    pub(super) fn sections(
        &mut self,
        work: &Work,
        (constant, mul_add): (&TokenStream, &TokenStream),
    ) -> TokenStream {
        let bound = self.dialect.bound_inside().map(|bound| quote! { <#bound> });
        let (name, kind) = (
            ident(&work.name),
            array(&self.dialect.number, &literal(work.len)),
        );
        let sections = work.sections.iter().map(|section| {
            let Apart {
                name: own,
                statements,
                has_literals,
                is_fused,
                ..
            } = section;
            let (own, taken) = (ident(own), self.taken(section));
            let constant = has_literals.then_some(constant);
            let mul_add = is_fused.then_some(mul_add);
            let statements = self.statements(statements);
            quote! {
                #[inline(never)]
                fn #own #bound(#name: &mut #kind) { #constant #mul_add #taken #statements }
            }
        });
        sections.collect()
    }

    /// The array, its initial values, and the calls.
    pub(super) fn calls(&self, work: &Work) -> TokenStream {
        let (name, zero) = (ident(&work.name), self.read(&Value::Literal(0.0)));
        let len = literal(work.len);
        let given = work.given.iter();
        let given = given.map(|(place, value)| self.put_at(*place, &self.read(value)));
        let calls = work.sections.iter().map(|section| {
            let section = ident(&section.name);
            quote! { #section(&mut #name); }
        });
        quote! { let mut #name = [#zero; #len]; #(#given)* #(#calls)* }
    }

    /// Bindings of the values that a section reads; a single one if there are more than a scope may have.
    fn taken(&self, section: &Apart) -> TokenStream {
        let names = section.taken.iter().map(|(_, name)| ident(name));
        let places = section.taken.iter().map(|(place, _)| self.place(*place));
        if section.taken.len() > LONGEST_SCOPE {
            return quote! { let [#(#names),*] = [#(#places),*]; };
        }
        quote! { #(let #names = #places;)* }
    }

    /// `work[3]`.
    pub(super) fn place(&self, place: usize) -> TokenStream {
        let (work, place) = (&self.work, Literal::usize_unsuffixed(place));
        quote! { #work[#place] }
    }

    /// `work[3] = a;`.
    pub(super) fn put_at(&self, place: usize, value: &impl ToTokens) -> TokenStream {
        let place = self.place(place);
        quote! { #place = #value; }
    }
}
