//! Steps of a robot some of whose coordinates are no angles and shifts: from a posture by velocities, and
//! from one posture to another.
//!
//! In: what moves each joint. Out: the methods `neutral`, `integrate`, `difference` and `normalize`, which
//! leave to the runtime what takes more than a sum. Robots whose coordinates are all added to have none, and
//! nor has code that cannot call the runtime.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::comments::doc;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::literal;
use super::world::World;
use crate::joint::Posture;
use crate::print::{DataMotion, Listing};
use crate::space::Space;

/// The methods, where the robot needs them.
pub(super) fn steps(listing: &Listing, item: &Item, dialect: &Dialect) -> TokenStream {
    let World::Runtime(runtime) = &dialect.world else {
        return TokenStream::new();
    };
    let motions = &listing.data.motions;
    let is_posture = |motion: &DataMotion| matches!(motion, DataMotion::Posture(_));
    if !motions.iter().any(is_posture) {
        return TokenStream::new();
    }
    let steps = Steps {
        motions,
        runtime,
        coordinates: listing.spaces.len(Space::Coordinates),
        velocities: listing.spaces.len(Space::Velocities),
    };
    let generics = dialect.bound().map(|bound| quote! { <#bound> });
    let (number, visibility) = (&dialect.number, &item.visibility);
    let [nq, nv] = [steps.coordinates, steps.velocities].map(literal);
    let (q, v) = (quote! { &[#number; #nq] }, quote! { &[#number; #nv] });
    let method = |about: [&str; 2], head: TokenStream, result: &TokenStream, body: TokenStream| {
        let about = doc(&about.map(str::to_owned));
        quote! { #about #[must_use] #visibility fn #head -> [#number; #result] { #body } }
    };
    let neutral = method(
        [
            "Coordinates at which every joint stands where it was placed.",
            "Zeros, and 0, 0, 0, 1 of quaternions (x, y, z, w).",
        ],
        quote! { neutral #generics(&self) },
        &nq,
        steps.neutral(number),
    );
    let integrate = method(
        [
            "Where the robot gets to from `q` with velocities kept for one unit of time; of a time Δt, `v` is q̇ Δt.",
            "Bodies whose velocities are seen in their own axes move along the screw that they keep.",
        ],
        quote! { integrate #generics(&self, q: #q, v: #v) },
        &nq,
        steps.integrate(),
    );
    let difference = method(
        [
            "The velocities that lead from `from` to `to` in one unit of time.",
            "Turns of bodies whose velocities are seen in their own axes are the shortest, half a turn at most.",
        ],
        quote! { difference #generics(&self, from: #q, to: #q) },
        &nv,
        steps.difference(),
    );
    let normalize = method(
        [
            "The same coordinates with quaternions of length 1.",
            "None of them may be zero.",
        ],
        quote! { normalize #generics(&self, q: #q) },
        &nq,
        steps.normalize(),
    );
    quote! { #neutral #integrate #difference #normalize }
}

/// What moves each joint, and how many entries all have.
struct Steps<'l> {
    motions: &'l [DataMotion],
    runtime: &'l TokenStream,
    coordinates: usize,
    velocities: usize,
}

/// The coordinates and velocities of a joint, and what moves it.
struct Own {
    motion: DataMotion,
    coordinates: std::ops::Range<usize>,
    velocities: std::ops::Range<usize>,
}

impl Steps<'_> {
    /// Those of each joint that has any.
    fn joints(&self) -> impl Iterator<Item = Own> {
        let (mut coordinate, mut velocity) = (0, 0);
        let motions = self.motions.iter().map(move |&motion| {
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

    fn neutral(&self, number: &TokenStream) -> TokenStream {
        let runtime = self.runtime;
        let entries = self.joints().flat_map(|own| {
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
        quote! { [#(<#number as #runtime::Scalar>::constant(#entries)),*] }
    }

    fn integrate(&self) -> TokenStream {
        let (q, v) = (
            names("q", 0..self.coordinates),
            names("v", 0..self.velocities),
        );
        let mut statements = quote! { let [#(#q),*] = *q; let [#(#v),*] = *v; };
        let mut results = Vec::new();
        for own in self.joints() {
            let (q, v) = (&q[own.coordinates.clone()], &v[own.velocities.clone()]);
            if let DataMotion::Posture(posture) = own.motion {
                let kernel = self.kernel("integrate", posture);
                let moved = names("moved", own.coordinates);
                statements.extend(quote! { let [#(#moved),*] = #kernel([#(#q),*], [#(#v),*]); });
                results.extend(moved.iter().map(|entry| quote! { #entry }));
            } else {
                results.extend(q.iter().zip(v).map(|(q, v)| quote! { #q + #v }));
            }
        }
        quote! { #statements [#(#results),*] }
    }

    fn difference(&self) -> TokenStream {
        let [from, to] = ["from", "to"].map(|name| names(name, 0..self.coordinates));
        let mut statements = quote! { let [#(#from),*] = *from; let [#(#to),*] = *to; };
        let mut results = Vec::new();
        for own in self.joints() {
            let [from, to] = [&from, &to].map(|names| &names[own.coordinates.clone()]);
            if let DataMotion::Posture(posture) = own.motion {
                let kernel = self.kernel("difference", posture);
                let apart = names("v", own.velocities);
                statements
                    .extend(quote! { let [#(#apart),*] = #kernel([#(#from),*], [#(#to),*]); });
                results.extend(apart.iter().map(|entry| quote! { #entry }));
            } else {
                results.extend(from.iter().zip(to).map(|(from, to)| quote! { #to - #from }));
            }
        }
        quote! { #statements [#(#results),*] }
    }

    fn normalize(&self) -> TokenStream {
        let runtime = self.runtime;
        let q = names("q", 0..self.coordinates);
        let mut statements = quote! { let [#(#q),*] = *q; };
        for own in self.joints() {
            if let Some(first) = quaternion(own.motion) {
                let quaternion = &q[own.coordinates][first..];
                let kernel = quote! { #runtime::robot::posture::normalized };
                let mended = quote! { #kernel([#(#quaternion),*]) };
                statements.extend(quote! { let [#(#quaternion),*] = #mended; });
            }
        }
        quote! { #statements [#(#q),*] }
    }

    /// What the runtime has for a posture.
    fn kernel(&self, verb: &str, posture: Posture) -> TokenStream {
        let runtime = self.runtime;
        let kernel = format_ident!(
            "{verb}_{}",
            match posture {
                Posture::Planar => "planar",
                Posture::Spherical => "spherical",
                Posture::Floating => "floating",
            }
        );
        quote! { #runtime::robot::posture::#kernel }
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

fn names(name: &str, entries: std::ops::Range<usize>) -> Vec<Ident> {
    entries.map(|k| format_ident!("{name}_{}", k + 1)).collect()
}
