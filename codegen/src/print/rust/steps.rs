//! The steps of a robot in Rust: `neutral`, `integrate`, `difference` and `normalize`.
//!
//! In: what moves each joint, and the functions that a robot has of these. Out: methods, which leave to kernels
//! what takes more than a sum: those of the runtime, or those that stand beside functions of numbers side by side.
//! Code for `core` alone has none of them.

use std::ops::Range;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::comments::doc;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{array, literal};
use super::world::World;
use crate::joint::Posture;
use crate::module::{DataMotion, Module};
use crate::print::steps::Step;
use crate::space::Space;

/// The methods, where the robot needs them.
pub(super) fn steps(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let of_robot = Step::of(module);
    if of_robot.is_empty() {
        return TokenStream::new();
    }
    let (kernels, neutral) = match &dialect.world {
        World::Runtime(runtime) => (
            quote! { #runtime::robot::posture },
            neutral(module, item, runtime, dialect),
        ),
        World::Lanes(path) => (quote! { #path::posture }, TokenStream::new()),
        World::Core(_) => return TokenStream::new(),
    };
    let steps = Steps {
        motions: &module.data.motions,
        kernels,
        dialect,
    };
    let methods = of_robot.iter().map(|&step| {
        let about = doc(&step.about().map(str::to_owned));
        let visibility = &item.visibility;
        let name = format_ident!("{}", step.name());
        let generics = dialect.bound().map(|bound| quote! { <#bound> });
        let row = |space| array(&dialect.number, &literal(module.spaces.len(space)));
        let arguments = step.arguments().iter().map(|&(argument, space)| {
            let (argument, row) = (dialect.local(argument), row(space));
            quote! { #argument: &#row }
        });
        let head = quote! { #visibility fn #name #generics(&self, #(#arguments),*) };
        let result = row(step.result());
        let (statements, entries) = steps.body(step, module);
        match &dialect.world {
            World::Lanes(_) => quote! {
                #about #[inline(always)] #head -> (#result,) { #statements ([#(#entries),*],) }
            },
            World::Runtime(_) | World::Core(_) => quote! {
                #about #[must_use] #head -> #result { #statements [#(#entries),*] }
            },
        }
    });
    quote! { #neutral #(#methods)* }
}

/// The method `neutral`.
fn neutral(module: &Module, item: &Item, runtime: &TokenStream, dialect: &Dialect) -> TokenStream {
    let about = doc(&[
        "Coordinates at which every joint stands where it was placed.".to_owned(),
        "Zeros, and 0, 0, 0, 1 of quaternions (x, y, z, w).".to_owned(),
    ]);
    let (number, visibility) = (&dialect.number, &item.visibility);
    let generics = dialect.bound().map(|bound| quote! { <#bound> });
    let row = array(number, &literal(module.spaces.len(Space::Coordinates)));
    let entries = joints(&module.data.motions).flat_map(|own| {
        let count = own.coordinates.len();
        let is_one = move |k| k + 1 == count && quaternion(own.motion).is_some();
        (0..count).map(move |k| {
            if is_one(k) {
                quote! { 1.0 }
            } else {
                quote! { 0.0 }
            }
        })
    });
    quote! {
        #about
        #[must_use]
        #visibility fn neutral #generics(&self) -> #row {
            [#(<#number as #runtime::Scalar>::constant(#entries)),*]
        }
    }
}

/// What moves each joint, and where functions of single joints are.
struct Steps<'l> {
    motions: &'l [DataMotion],
    kernels: TokenStream,
    dialect: &'l Dialect,
}

/// The coordinates and velocities of a joint, and what moves it.
struct Own {
    motion: DataMotion,
    coordinates: Range<usize>,
    velocities: Range<usize>,
}

/// Those of each joint that has any.
fn joints(motions: &[DataMotion]) -> impl Iterator<Item = Own> {
    let (mut coordinate, mut velocity) = (0, 0);
    let motions = motions.iter().map(move |&motion| {
        let (coordinates, velocities) = motion.counts();
        let own = Own {
            motion,
            coordinates: coordinate..coordinate + coordinates,
            velocities: velocity..velocity + velocities,
        };
        (coordinate, velocity) = (own.coordinates.end, own.velocities.end);
        own
    });
    motions.filter(|own| !own.coordinates.is_empty())
}

impl Steps<'_> {
    /// Statements, and the entries of the result.
    fn body(&self, step: Step, module: &Module) -> (TokenStream, Vec<TokenStream>) {
        let arguments = step.arguments().iter().map(|&(argument, space)| {
            let entries = self.names(argument, 0..module.spaces.len(space));
            (self.dialect.local(argument), entries)
        });
        let (arguments, entries): (Vec<_>, Vec<_>) = arguments.unzip();
        let mut statements = quote! { #(let [#(#entries),*] = *#arguments;)* };
        let results = match (step, &*entries) {
            (Step::Integrate, [q, v]) => self.integrate(&mut statements, q, v),
            (Step::Difference, [start, end]) => self.difference(&mut statements, start, end),
            (_, entries) => self.normalize(&mut statements, &entries[0]),
        };
        (statements, results)
    }

    fn integrate(
        &self,
        statements: &mut TokenStream,
        q: &[Ident],
        v: &[Ident],
    ) -> Vec<TokenStream> {
        let mut results = Vec::new();
        for own in joints(self.motions) {
            let (q, v) = (&q[own.coordinates.clone()], &v[own.velocities]);
            if let DataMotion::Posture(posture) = own.motion {
                let kernel = self.kernel("integrate", posture);
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
        for own in joints(self.motions) {
            let [q0, q1] = [q0, q1].map(|names| &names[own.coordinates.clone()]);
            if let DataMotion::Posture(posture) = own.motion {
                let kernel = self.kernel("difference", posture);
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
        let kernels = &self.kernels;
        for own in joints(self.motions) {
            if let Some(first) = quaternion(own.motion) {
                let quaternion = &q[own.coordinates][first..];
                let mended = quote! { #kernels::normalized([#(#quaternion),*]) };
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

    /// What there is for a posture.
    fn kernel(&self, verb: &str, posture: Posture) -> TokenStream {
        let kernels = &self.kernels;
        let kernel = format_ident!(
            "{verb}_{}",
            match posture {
                Posture::Planar => "planar",
                Posture::Spherical => "spherical",
                Posture::Floating => "floating",
            }
        );
        quote! { #kernels::#kernel }
    }
}

/// Where the quaternion begins among the coordinates of a joint, if it has one.
const fn quaternion(motion: DataMotion) -> Option<usize> {
    match motion {
        DataMotion::Posture(Posture::Spherical) => Some(0),
        DataMotion::Posture(Posture::Floating) => Some(3),
        _ => None,
    }
}
