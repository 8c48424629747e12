//! `neutral`, `integrate`, `difference` and `normalize` of a robot in Rust.
//!
//! In: the motion of each joint. Out: methods. With the runtime they call its functions of single joints; otherwise
//! they are the statements that every language prints.

use std::ops::Range;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

#[cfg(feature = "files")]
use super::body;
use super::comments::doc;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{array, literal};
use super::library::Library;
use super::literals::Numerals;
use super::names::ident;
use crate::joint::Manifold;
use crate::module::{DataMotion, Module};
use crate::print::documentation;
use crate::print::steps::{ConfigurationFunction, joints, neutral};

/// The methods, if the robot needs them.
pub(super) fn steps(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let methods = ConfigurationFunction::of(module).iter().map(|&step| {
        let about = doc(&documentation::of_step(
            module,
            step,
            dialect.angles().as_ref(),
        ));
        let visibility = &item.visibility;
        let name = ident(step.name());
        let generics = dialect.bound().map(|bound| quote! { <#bound> });
        let row = |space| array(&dialect.number, &literal(module.spaces.len(space)));
        let arguments = step.arguments().iter().map(|&(argument, space)| {
            let (argument, row) = (dialect.local(argument), row(space));
            quote! { #argument: &#row }
        });
        let head = quote! { #visibility fn #name #generics(&self #(, #arguments)*) };
        let result = row(step.result());
        let (statements, entries) = computation(step, module, dialect);
        match &dialect.library {
            // The class has an attribute for it.
            Library::Lanes(_) if step == ConfigurationFunction::Neutral => TokenStream::new(),
            Library::Lanes(_) => quote! {
                #about #[inline(always)] #head -> (#result,) { #statements ([#(#entries),*],) }
            },
            Library::Runtime(_) | Library::Core(_) => quote! {
                #about #[must_use] #head -> #result { #statements [#(#entries),*] }
            },
        }
    });
    methods.collect()
}

/// Statements, and the entries of the result.
fn computation(
    step: ConfigurationFunction,
    module: &Module,
    dialect: &Dialect,
) -> (TokenStream, Vec<TokenStream>) {
    match &dialect.library {
        Library::Runtime(runtime) => StepMethods {
            module,
            runtime,
            dialect,
        }
        .body(step),
        #[cfg(feature = "files")]
        Library::Core(_) | Library::Lanes(_) => body::of_step(step, module, dialect),
        #[cfg(not(feature = "files"))]
        Library::Core(_) | Library::Lanes(_) => Default::default(),
    }
}

/// Methods that call functions of single joints.
struct StepMethods<'l> {
    module: &'l Module,
    runtime: &'l TokenStream,
    dialect: &'l Dialect,
}

impl StepMethods<'_> {
    fn body(&self, step: ConfigurationFunction) -> (TokenStream, Vec<TokenStream>) {
        let arguments = step.arguments().iter().map(|&(argument, space)| {
            let entries = self.names(argument, 0..self.module.spaces.len(space));
            (self.dialect.local(argument), entries)
        });
        let (arguments, entries): (Vec<_>, Vec<_>) = arguments.unzip();
        let mut statements = quote! { #(let [#(#entries),*] = *#arguments;)* };
        let results = match (step, &*entries) {
            (ConfigurationFunction::Integrate, [q, v]) => self.integrate(&mut statements, q, v),
            (ConfigurationFunction::Difference, [start, end]) => {
                self.difference(&mut statements, start, end)
            }
            (ConfigurationFunction::Normalize, [q]) => self.normalize(&mut statements, q),
            _ => self.neutral(),
        };
        (statements, results)
    }

    fn neutral(&self) -> Vec<TokenStream> {
        let (number, runtime) = (&self.dialect.number, self.runtime);
        let entries = neutral(self.module).into_iter();
        entries
            .map(|entry| Numerals::Bare.write(entry))
            .map(|entry| quote! { <#number as #runtime::Scalar>::constant(#entry) })
            .collect()
    }

    fn integrate(
        &self,
        statements: &mut TokenStream,
        q: &[Ident],
        v: &[Ident],
    ) -> Vec<TokenStream> {
        let mut results = Vec::new();
        for own in joints(self.module) {
            let (q, v) = (&q[own.coordinates.clone()], &v[own.velocities]);
            if let DataMotion::Manifold(manifold) = own.motion {
                let kernel = self.kernel("integrate", manifold);
                let moved = self.names("moved", own.coordinates);
                statements.extend(quote! { let [#(#moved),*] = #kernel([#(#q),*], [#(#v),*]); });
                results.extend(moved.iter().map(|entry| quote! { #entry }));
            } else {
                results.extend(q.iter().zip(v).map(|(q, v)| quote! { #q + #v }));
            }
        }
        results
    }

    fn difference(
        &self,
        statements: &mut TokenStream,
        q0: &[Ident],
        q1: &[Ident],
    ) -> Vec<TokenStream> {
        let mut results = Vec::new();
        for own in joints(self.module) {
            let [q0, q1] = [q0, q1].map(|names| &names[own.coordinates.clone()]);
            if let DataMotion::Manifold(manifold) = own.motion {
                let kernel = self.kernel("difference", manifold);
                let v = self.names("v", own.velocities);
                statements.extend(quote! { let [#(#v),*] = #kernel([#(#q0),*], [#(#q1),*]); });
                results.extend(v.iter().map(|entry| quote! { #entry }));
            } else {
                results.extend(q0.iter().zip(q1).map(|(q0, q1)| quote! { #q1 - #q0 }));
            }
        }
        results
    }

    fn normalize(&self, statements: &mut TokenStream, q: &[Ident]) -> Vec<TokenStream> {
        let runtime = self.runtime;
        for own in joints(self.module) {
            if let Some(first) = own.quaternion() {
                let quaternion = &q[own.coordinates][first..];
                let mended = quote! { #runtime::robot::manifold::normalized([#(#quaternion),*]) };
                statements.extend(quote! { let [#(#quaternion),*] = #mended; });
            }
        }
        q.iter().map(|entry| quote! { #entry }).collect()
    }

    /// Names of some entries.
    fn names(&self, name: &str, entries: Range<usize>) -> Vec<Ident> {
        let names = entries.map(|k| format!("{name}_{}", k + 1));
        names.map(|name| self.dialect.local(&name)).collect()
    }

    /// Function of a single joint.
    fn kernel(&self, verb: &str, manifold: Manifold) -> TokenStream {
        let runtime = self.runtime;
        let kernel = format_ident!("{verb}_{}", manifold.word());
        quote! { #runtime::robot::manifold::#kernel }
    }
}
