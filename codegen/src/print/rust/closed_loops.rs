//! The robot with its loops as data in Rust.
//!
//! In: [`LoopsData`](crate::module::LoopsData). Out: the function `mechanism`, which returns the runtime's `Mechanism`
//! for the generic recursions that generated code is compared with; nothing without loops.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::{FunctionBody, Returns, body};
use super::chain::index;
use super::comments::doc;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::literal;
use super::library::Library;
use super::results::square_and_column;
use crate::closure::ResidualKind;
use crate::module::{LoopData, Module};
use crate::print::{Fields, documentation};
use crate::schedule::Length;
use crate::space::Space;

/// Count of numbers of a frame, and of a loop.
const PLACEMENT: usize = 12;
const LOOP: usize = 2 * PLACEMENT + 1;

/// `fn mechanism() -> ::homogen::Mechanism<N, F, C, Q, B>`, a method if fields enter it.
pub(super) fn closed_loops(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let Library::Runtime(runtime) = &dialect.library else {
        return TokenStream::new();
    };
    let data = &module.data;
    if data.loops.loops.is_empty() {
        return TokenStream::new();
    }
    let FunctionBody {
        statements,
        results,
        ..
    } = body(
        (&data.loops.program, Length::UNBOUNDED),
        (&[], Returns::Arrays),
        (Fields::Own(&module.parameters), &module.spaces),
        &dialect.of_data(),
    );
    let results = results.numbers();
    let loops = data.loops.loops.iter().zip(results.chunks(LOOP));
    let residuals = loops.flat_map(|(closed, numbers)| residuals(closed, numbers, runtime));
    let actuated = &data.loops.actuated;

    let about = doc(&documentation::of_mechanism(module));
    let visibility = &item.visibility;
    let length = |space: Space| literal(module.spaces.len(space));
    let [velocities, constraints, coordinates] =
        [Space::Velocities, Space::Constraints, Space::Coordinates].map(length);
    let [frames, joints] = [data.frames.len(), data.names.len()].map(literal);
    let reads_fields = !module.parameters.is_empty();
    let this = reads_fields.then(|| quote! { &self });
    let constant = (!reads_fields).then(|| quote! { const });
    let chain = if reads_fields {
        quote! { self.chain() }
    } else {
        quote! { Self::chain() }
    };
    quote! {
        #about
        #[must_use]
        #visibility #constant fn closed_loops(#this) -> #runtime::ClosedLoopRobot<
            #velocities, #frames, #constraints, #coordinates, #joints
        > {
            #statements
            #runtime::ClosedLoopRobot::new(#chain, [#(#residuals),*], [#(#actuated),*])
        }
    }
}

/// Signature for an unknown description, generic over all lengths.
pub(super) fn absent(reads_fields: bool, runtime: &TokenStream) -> TokenStream {
    let this = reads_fields.then(|| quote! { &self });
    let names = ["N", "F", "C", "Q", "B"].map(|name| quote::format_ident!("{name}"));
    quote! {
        fn closed_loops<#(const #names: ::core::primitive::usize),*>(
            #this
        ) -> #runtime::ClosedLoopRobot<#(#names),*>
    }
}

/// Residuals of a loop, with its frames and its size.
fn residuals<'a>(
    closed: &'a LoopData,
    numbers: &'a [TokenStream],
    runtime: &'a TokenStream,
) -> impl Iterator<Item = TokenStream> + 'a {
    closed.rows.iter().map(move |row| {
        let frames = closed.frames.iter().zip(numbers.chunks(PLACEMENT));
        let frames = frames.map(|((name, body), numbers)| {
            let (body, placement) = (index(*body), square_and_column(numbers));
            quote! { #runtime::Frame::new(#name, #body, #runtime::Pose::new(#placement)) }
        });
        let size = &numbers[2 * PLACEMENT];
        let kind = match *row {
            ResidualKind::Along(k) => {
                let k = literal(k);
                quote! { Along(#k) }
            }
            ResidualKind::Product(i, j) => {
                let [i, j] = [i, j].map(literal);
                quote! { Product(#i, #j) }
            }
            ResidualKind::Inclined => quote! { Inclined(#size) },
            ResidualKind::Distance => quote! { Distance(#size) },
        };
        let name = row.name(&closed.name);
        quote! { #runtime::Residual::new(#name, [#(#frames),*], #runtime::ResidualKind::#kind) }
    })
}
