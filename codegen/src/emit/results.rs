//! The types of results, and the expressions that make them.
//!
//! In: a shape and its numbers. Out: the runtime's typed matrices, or arrays where there is no
//! runtime. It never reorders the numbers of a program.

use proc_macro2::TokenStream;
use quote::quote;

use super::dialect::{Dialect, World};
use crate::function::{Function, Shape};

/// The type of what `functions` return together, for `joints` joints.
pub(super) fn result_type(
    functions: &[Function],
    joints: &TokenStream,
    dialect: &Dialect,
) -> TokenStream {
    let types = functions
        .iter()
        .map(|function| type_of(function.shape(), joints, dialect));
    one_or_tuple(types.collect())
}

/// The type of one result.
pub(super) fn type_of(shape: Shape, n: &TokenStream, dialect: &Dialect) -> TokenStream {
    let number = &dialect.number;
    match (shape, &dialect.world) {
        (Shape::Vector, _) => quote! { [#number; #n] },
        (Shape::Matrix, _) => quote! { [[#number; #n]; #n] },
        (Shape::Pose, World::Runtime(runtime)) => quote! { #runtime::Pose<#number> },
        (Shape::Velocity, World::Runtime(runtime)) => quote! { #runtime::Velocity<#number> },
        (Shape::Acceleration, World::Runtime(runtime)) => {
            quote! { #runtime::Acceleration<#number> }
        }
        (Shape::Screws, World::Runtime(runtime)) => quote! { [#runtime::Screw<#number>; #n] },
        (Shape::Pose | Shape::Acceleration, World::Core(_)) => quote! { [[#number; 4]; 3] },
        (Shape::Velocity, World::Core(_)) => quote! { [#number; 6] },
        (Shape::Screws, World::Core(_)) => quote! { [[#number; 6]; #n] },
    }
}

/// The value of what `functions` return together: their numbers stand one after the other.
pub(super) fn result_value(
    functions: &[Function],
    joints: usize,
    numbers: &[TokenStream],
    dialect: &Dialect,
) -> TokenStream {
    let mut rest = numbers;
    let values = functions.iter().map(|function| {
        let shape = function.shape();
        let (own, others) = rest.split_at(shape.len(joints).min(rest.len()));
        rest = others;
        value_of(shape, joints, own, dialect)
    });
    one_or_tuple(values.collect())
}

fn value_of(
    shape: Shape,
    joints: usize,
    numbers: &[TokenStream],
    dialect: &Dialect,
) -> TokenStream {
    match (shape, &dialect.world) {
        (Shape::Vector, _) | (Shape::Velocity, World::Core(_)) => quote! { [#(#numbers),*] },
        (Shape::Matrix, _) => rows(numbers, joints),
        (Shape::Pose, World::Runtime(runtime)) => {
            let blocks = square_and_column(numbers);
            quote! { #runtime::Pose::new(#blocks) }
        }
        (Shape::Acceleration, World::Runtime(runtime)) => {
            let blocks = square_and_column(numbers);
            quote! { #runtime::Acceleration::new(#blocks) }
        }
        (Shape::Velocity, World::Runtime(runtime)) => {
            let blocks = two_vectors(numbers);
            quote! { #runtime::Velocity::new(#blocks) }
        }
        (Shape::Screws, World::Runtime(runtime)) => {
            let columns = numbers.chunks(6).map(two_vectors);
            quote! { [#(#runtime::Screw::new(#columns)),*] }
        }
        (Shape::Pose | Shape::Acceleration, World::Core(_)) => rows(numbers, 4),
        (Shape::Screws, World::Core(_)) => rows(numbers, 6),
    }
}

/// The rows of an upper 3×4 block as `[[…]; 3], […]`.
pub(super) fn square_and_column(numbers: &[TokenStream]) -> TokenStream {
    let square = numbers.chunks(4).map(|row| {
        let row = row.iter().take(3);
        quote! { [#(#row),*] }
    });
    let column = numbers.chunks(4).filter_map(|row| row.get(3));
    quote! { [#(#square),*], [#(#column),*] }
}

/// Six numbers as `[…], […]`.
pub(super) fn two_vectors(numbers: &[TokenStream]) -> TokenStream {
    let (first, second) = numbers.split_at(3.min(numbers.len()));
    quote! { [#(#first),*], [#(#second),*] }
}

fn rows(numbers: &[TokenStream], width: usize) -> TokenStream {
    // `chunks` wants a width even of a robot without joints.
    let rows = numbers
        .chunks(width.max(1))
        .map(|row| quote! { [#(#row),*] });
    quote! { [#(#rows),*] }
}

fn one_or_tuple(mut items: Vec<TokenStream>) -> TokenStream {
    if items.len() == 1 {
        items.remove(0)
    } else {
        quote! { (#(#items),*) }
    }
}
