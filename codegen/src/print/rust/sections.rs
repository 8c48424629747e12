//! Sections of a long routine in Rust.
//!
//! In: the [`Work`] of a routine. Out: a function for each section, within its caller, and the calls. Indices of the
//! work array are literals below its length, so that none can fail.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::{Generics, parse_quote};

use super::body::RustWriter;
use super::dispatch::{EquationArgument, dispatched};
use super::lengths::{array, literal};
use super::literals::Numerals;
use super::names::ident;
use crate::print::expression::{Spelling, subscript};
use crate::schedule::{Cells, LONGEST_SCOPE, SectionBody, Value, Work};

impl RustWriter<'_> {
    /// The functions; `constant` and `mul_add` are statements that bind the functions for literals and fused products.
    pub(super) fn sections(
        &mut self,
        work: &Work,
        (constant, mul_add): (&TokenStream, &TokenStream),
    ) -> TokenStream {
        let bound = self.dialect.bound_inside().map(|bound| quote! { <#bound> });
        // What is not inlined chooses its instructions by itself.
        let generics: Generics = parse_quote! { #bound };
        let (name, kind) = (
            ident(&work.name),
            array(&self.dialect.number, &literal(work.len)),
        );
        let inlined = self.like_those_of(&name);
        let read = inlined.is_some().then(|| quote! { self.0[0] });
        let constant = inlined.as_ref().unwrap_or(constant);
        let sections = work.sections.iter().map(|section| {
            let SectionBody {
                name: own,
                statements,
                has_literals,
                is_fused,
                ..
            } = section;
            let (own, loads) = (ident(own), self.loads(section));
            let constant = has_literals.then_some(constant);
            let mul_add = is_fused.then_some(mul_add);
            let statements = self.statements(statements);
            let equations = quote! { #constant #mul_add #loads #statements };
            let argument = EquationArgument {
                name: quote! { #name },
                value: quote! { #name },
                of: quote! { &mut #kind },
            };
            let code = dispatched(
                (&[argument], &generics),
                (None, read.as_ref()),
                &equations,
                self.dialect,
            );
            quote! {
                #[inline(never)]
                fn #own #bound(#name: &mut #kind) { #code }
            }
        });
        sections.collect()
    }

    /// The statement that binds the function for literals, if functions are inlined: they are made like a number of the
    /// work array.
    fn like_those_of(&self, work: &Ident) -> Option<TokenStream> {
        let Numerals::Through(constant) = &self.numerals else {
            return None;
        };
        let first = self.dialect.local("first");
        let like = self.dialect.like(&quote! { #first })?;
        Some(quote! { let #constant = { let #first = #work[0]; move #like }; })
    }

    /// The array, its initial values, and the calls.
    pub(super) fn calls(&self, work: &Work) -> TokenStream {
        let (name, zero) = (ident(&work.name), self.read(&Value::Literal(0.0)));
        let len = literal(work.len);
        let initial = work.initial.iter();
        let initial = initial.map(|(place, value)| self.put_at(*place, &self.read(value)));
        let calls = work.sections.iter().map(|section| {
            let section = ident(&section.name);
            quote! { #section(&mut #name); }
        });
        quote! { let mut #name = [#zero; #len]; #(#initial)* #(#calls)* }
    }

    /// Bindings of the values that a section reads; a single one if there are more than a scope may have.
    fn loads(&self, section: &SectionBody) -> TokenStream {
        let names = section.loads.iter().map(|(_, name)| ident(name));
        let places = section.loads.iter().map(|(place, _)| self.place(*place));
        if section.loads.len() > LONGEST_SCOPE {
            return quote! { let [#(#names),*] = [#(#places),*]; };
        }
        quote! { #(let #names = #places;)* }
    }

    /// `columns[3][column]` or `work[7 + column]`.
    pub(super) fn cell(&self, row: &Cells, column: &str) -> TokenStream {
        match row {
            Cells::Table(table, row) => {
                let column = ident(column);
                let (table, row) = (ident(table), Literal::usize_unsuffixed(*row));
                quote! { #table[#row][#column] }
            }
            Cells::Work(first) => {
                let column = ident(column).into_token_stream();
                let (work, place) = (&self.work, subscript(*first, &[(1, &column)]));
                quote! { #work[#place] }
            }
        }
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
