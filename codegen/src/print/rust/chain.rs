//! The robot as data in Rust.
//!
//! In: [`ChainData`]. Out: the function `chain`, which returns the runtime's `Chain` for the generic recursions that
//! generated code is compared with.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::body::{FunctionBody, Returns, body};
use super::comments::doc;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{Lengths, known, literal};
use super::library::Library;
use super::literals::Numerals;
use super::results::{square_and_column, two_vectors};
use crate::module::{ChainData, DataMotion, Module};
use crate::print::{Fields, documentation};
use crate::schedule::Length;
use crate::space::Space;

/// Count of numbers of a joint, and of its placement and screw.
const JOINT: usize = 28;
const PLACEMENT: usize = 12;
const SCREW: usize = 6;

/// `fn chain() -> ::homogen::Chain<N, F>`, a method if fields enter it.
pub(super) fn chain(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let Library::Runtime(runtime) = &dialect.library else {
        return TokenStream::new();
    };
    let data = &module.data;
    let FunctionBody {
        statements,
        results,
        ..
    } = body(
        (&data.program, Length::UNBOUNDED),
        (&[], Returns::Arrays),
        (Fields::Own(&module.parameters), &module.spaces),
        &dialect.of_data(),
    );
    let results = results.numbers();
    let value = value(data, &results, runtime);

    let about = doc(&documentation::of_chain(module));
    let visibility = &item.visibility;
    let lengths = known(&module.spaces);
    let signature = signature(
        (
            &lengths,
            &literal(data.names.len()),
            &literal(data.frames.len()),
        ),
        None,
        !module.parameters.is_empty(),
        runtime,
    );
    // Without parameters the function is constant.
    let constant = module.parameters.is_empty().then(|| quote! { const });
    quote! {
        #about
        #[must_use]
        #visibility #constant #signature { #statements #value }
    }
}

/// Signature for these lengths of lists and numbers of joints and frames; `unknown` is a generic parameter for a
/// length.
pub(super) fn signature(
    (lengths, joints, frames): (Lengths<'_>, &TokenStream, &TokenStream),
    unknown: Option<&TokenStream>,
    reads_fields: bool,
    runtime: &TokenStream,
) -> TokenStream {
    let this = reads_fields.then(|| quote! { &self });
    let generics = unknown.map(|unknown| quote! { <#unknown> });
    let chain = chain_type(lengths, joints, frames, runtime);
    quote! { fn chain #generics(#this) -> #chain }
}

/// Type of a robot as data for these lengths of lists and numbers of joints and frames.
pub(super) fn chain_type(
    lengths: Lengths<'_>,
    joints: &TokenStream,
    frames: &TokenStream,
    runtime: &TokenStream,
) -> TokenStream {
    let [coordinates, velocities] = [Space::Coordinates, Space::Velocities].map(lengths);
    let same = |a: &TokenStream, b: &TokenStream| a.to_string() == b.to_string();
    // If every joint has one coordinate, a single length suffices.
    let others = if same(&coordinates, &velocities) && same(joints, &velocities) {
        None
    } else {
        Some(quote! { , #coordinates, #joints })
    };
    quote! { #runtime::Chain<#velocities, #frames #others> }
}

fn value(data: &ChainData, numbers: &[TokenStream], runtime: &TokenStream) -> TokenStream {
    let (joints, rest) = numbers.split_at((data.names.len() * JOINT).min(numbers.len()));
    let (frames, rest) = rest.split_at((data.frames.len() * PLACEMENT).min(rest.len()));
    let (gravity, actuators) = rest.split_at(rest.len().min(3));
    let names = data.names.iter().zip(&data.parents).zip(&data.motions);
    let joints = joints.chunks(JOINT).zip(names);
    let joints = (0_u16..).zip(joints);
    let joints = joints.map(|(k, (numbers, ((name, parent), motion)))| {
        let joint = joint((name, index(*parent)), *motion, numbers, runtime);
        let own = data.actuated.iter().zip(actuators.chunks(3));
        let own = own.filter(|((joint, _), _)| *joint == k);
        let with = own.map(|((_, velocity), actuator)| {
            let velocity = literal((*velocity).into());
            quote! { .with_actuator(#velocity, #runtime::JointActuator::new(#(#actuator),*)) }
        });
        quote! { #joint #(#with)* }
    });
    let frames = frames.chunks(PLACEMENT).zip(&data.frames);
    let frames = frames.map(|(numbers, (name, body))| {
        let (body, placement) = (index(*body), square_and_column(numbers));
        quote! { #runtime::Frame::new(#name, #body, #runtime::Pose::new(#placement)) }
    });
    quote! { #runtime::Chain::new([#(#joints),*], [#(#frames),*], [#(#gravity),*]) }
}

fn joint(
    (name, parent): (&str, TokenStream),
    motion: DataMotion,
    numbers: &[TokenStream],
    runtime: &TokenStream,
) -> TokenStream {
    let (placement, rest) = numbers.split_at(PLACEMENT);
    let (screw, inertia) = rest.split_at(SCREW);
    let (second, first_and_mass) = inertia.split_at(6);
    let (first, mass) = first_and_mass.split_at(3);
    let placement = square_and_column(placement);
    let placement = quote! { #runtime::Pose::new(#placement) };
    let inertia = quote! { #runtime::Inertia::new([#(#second),*], [#(#first),*], #(#mass),*) };
    let screw = two_vectors(screw);
    let along = quote! {
        #runtime::Joint::new(#name, #parent, #placement, #runtime::Screw::new(#screw), #inertia)
    };
    match motion {
        DataMotion::Along => along,
        DataMotion::Mimic {
            mimicked,
            multiplier,
        } => {
            let mimicked = literal(mimicked.into());
            let multiplier = Numerals::Bare.write(multiplier);
            quote! { #along.mimic(#mimicked, #multiplier) }
        }
        DataMotion::Manifold(manifold) => {
            let manifold = format_ident!("{}", manifold.word());
            quote! { #runtime::Joint::#manifold(#name, #parent, #placement, #inertia) }
        }
    }
}

/// Type of motion of a joint.
pub(super) fn motion_of(motion: DataMotion, runtime: &TokenStream) -> TokenStream {
    let kind = match motion {
        DataMotion::Along => quote! { Along },
        DataMotion::Mimic {
            mimicked,
            multiplier,
        } => {
            let mimicked = literal(mimicked.into());
            let multiplier = Numerals::Bare.write(multiplier);
            quote! { Mimic { mimicked: #mimicked, multiplier: #multiplier } }
        }
        DataMotion::Manifold(manifold) => {
            // Variants of the runtime have the names of the engine's.
            let manifold = format_ident!("{manifold:?}");
            quote! { #manifold }
        }
    };
    quote! { #runtime::Motion::#kind }
}

/// Joint that carries an item, as an option.
pub(super) fn index(joint: Option<u16>) -> TokenStream {
    if let Some(joint) = joint {
        let joint = literal(joint.into());
        quote! { ::core::option::Option::Some(#joint) }
    } else {
        quote! { ::core::option::Option::None }
    }
}
