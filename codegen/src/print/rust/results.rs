//! Types of results, and the expressions that construct them.
//!
//! In: a quantity and its numbers. Out: the runtime's matrix types, or arrays without the runtime, in arrays over their
//! spaces; structs for several quantities, from the runtime or in the file.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};
use syn::ext::IdentExt;

use super::body::{Number, Numbers};
use super::comments::doc;
use super::dialect::Dialect;
use super::item::Item;
use super::lengths::{Lengths, array, known, literal};
use super::library::Library;
use super::names::ident;
use crate::function::Function;
use crate::module::Module;
use crate::print::copies::Copies;
use crate::print::expression::subscript;
use crate::schedule::Value;
use crate::space::{Entity, Outcome, Quantity, Space, Spaces};

/// Type of the results of `functions`.
pub(super) fn result_type(
    functions: &[Function],
    lengths: Lengths<'_>,
    dialect: &Dialect,
) -> TokenStream {
    let types = functions.iter().map(|&function| match function.result() {
        Outcome::One(quantity) => type_of(&quantity, lengths, dialect),
        outcome @ Outcome::Parts(name, _) => {
            let path = structure(name, dialect);
            match dialect.library {
                Library::Runtime(_) => {
                    let lengths = spaces(outcome).into_iter().map(lengths);
                    let number = &dialect.number;
                    quote! { #path<#(#lengths,)* #number> }
                }
                Library::Core(_) | Library::Lanes(_) => path,
            }
        }
    });
    one_or_tuple(types.collect())
}

/// Spaces of some quantities, each once.
fn spaces(outcome: Outcome) -> Vec<Space> {
    let mut found = Vec::new();
    for &space in outcome.parts().flat_map(|(_, part)| part.over) {
        if !found.contains(&space) {
            found.push(space);
        }
    }
    found
}

/// Path of the struct for a function with several quantities.
fn structure(name: &str, dialect: &Dialect) -> TokenStream {
    match &dialect.library {
        Library::Runtime(runtime) => {
            let name = format_ident!("{name}");
            quote! { #runtime::#name }
        }
        Library::Core(_) | Library::Lanes(_) => {
            let name = own_structure(name, dialect);
            quote! { #name }
        }
    }
}

/// Name of that struct without the runtime.
fn own_structure(name: &str, dialect: &Dialect) -> Ident {
    format_ident!("{}{name}", dialect.robot.unraw())
}

/// Structs for results without the runtime.
pub(super) fn own_structures(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    let Library::Core(_) = dialect.library else {
        return TokenStream::new();
    };
    let mut functions: Vec<Function> = (module.functions.iter())
        .flat_map(|generated| generated.functions.iter().copied())
        .collect();
    functions.sort_unstable();
    functions.dedup();
    let lengths = known(&module.spaces);
    let structures = functions.into_iter().filter_map(|function| {
        let Outcome::Parts(name, parts) = function.result() else {
            return None;
        };
        let name = own_structure(name, dialect);
        let about = doc(&[format!(
            "Result of [`{}::{}`].",
            item.ident.unraw(),
            function.name()
        )]);
        let visibility = &item.visibility;
        let fields = parts.iter().map(|part| {
            let field = ident(part.name);
            let about = doc(&[part.about.to_owned()]);
            let kind = type_of(&part.quantity, &lengths, dialect);
            quote! { #about pub #field: #kind }
        });
        Some(quote! {
            #about
            #[derive(Clone, Copy, Debug, PartialEq)]
            #visibility struct #name { #(#fields),* }
        })
    });
    structures.collect()
}

/// Type of one result.
pub(super) fn type_of(quantity: &Quantity, lengths: Lengths<'_>, dialect: &Dialect) -> TokenStream {
    let number_type = &dialect.number;
    let one = match named(quantity.entity, dialect) {
        Some(path) => quote! { #path<#number_type> },
        None => (quantity.entity.dimensions().iter().rev())
            .fold(quote! { #number_type }, |one, &length| {
                array(&one, &literal(length))
            }),
    };
    let over = quantity.over.iter().rev();
    over.fold(one, |one, &space| array(&one, &lengths(space)))
}

/// Type of an entity in the runtime, if it has one.
fn named(entity: Entity, dialect: &Dialect) -> Option<TokenStream> {
    match (entity, &dialect.library) {
        (Entity::Number | Entity::Vector, _) | (_, Library::Core(_) | Library::Lanes(_)) => None,
        (entity, Library::Runtime(runtime)) => {
            // Types have the names of the variants.
            let name = format_ident!("{entity:?}");
            Some(quote! { #runtime::#name })
        }
    }
}

/// Value of the results of `functions`, from their numbers in order.
pub(super) fn result_value(
    functions: &[Function],
    spaces: &Spaces,
    numbers: &Numbers,
    dialect: &Dialect,
) -> TokenStream {
    let mut rest = &*numbers.entries;
    let values = functions.iter().map(|&function| {
        let outcome = function.result();
        let (own, others) = rest.split_at(outcome.size(spaces).min(rest.len()));
        rest = others;
        let parts = outcome.parts().zip(outcome.split(spaces, own));
        let values = parts.map(|((field, quantity), own)| {
            let value = value_of((&quantity, spaces), own, numbers, dialect);
            match field.map(ident) {
                Some(field) => quote! { #field: #value },
                None => value,
            }
        });
        match outcome {
            Outcome::One(_) => quote! { #(#values)* },
            Outcome::Parts(name, _) => {
                let path = structure(name, dialect);
                quote! { #path { #(#values),* } }
            }
        }
    });
    one_or_tuple(values.collect())
}

fn value_of(
    (quantity, spaces): (&Quantity, &Spaces),
    own: &[Number],
    numbers: &Numbers,
    dialect: &Dialect,
) -> TokenStream {
    let entity = quantity.entity;
    let lengths = quantity.lengths(spaces);
    match named(entity, dialect) {
        Some(path) => {
            let own: Vec<_> = own.iter().map(|number| number.text.clone()).collect();
            let whole = own
                .chunks(entity.size())
                .map(|numbers| match entity.dimensions() {
                    [3] => quote! { #path([#(#numbers),*]) },
                    [3, 4] => made(&path, &square_and_column(numbers)),
                    _ => made(&path, &two_vectors(numbers)),
                });
            let whole: Vec<_> = whole.collect();
            nested(&lengths, &whole)
        }
        None => nested_numbers(&[&lengths, entity.dimensions()].concat(), own, numbers),
    }
}

fn made(path: &TokenStream, blocks: &TokenStream) -> TokenStream {
    quote! { #path::new(#blocks) }
}

/// Nested arrays of the given lengths, the outermost first.
fn nested<T: ToTokens>(lengths: &[usize], values: &[T]) -> TokenStream {
    let Some((_, inner)) = lengths.split_first() else {
        return quote! { #(#values)* };
    };
    let rows = rows(inner, values).map(|values| nested(inner, values));
    quote! { [#(#rows),*] }
}

/// The same for numbers, whose matrices loops may copy.
fn nested_numbers(lengths: &[usize], values: &[Number], numbers: &Numbers) -> TokenStream {
    let inner = match lengths {
        [] | [_] => return nested(lengths, values),
        [_, columns] => match copied(values, *columns, numbers) {
            Some(matrix) => return matrix,
            None => return nested(lengths, values),
        },
        [_, inner @ ..] => inner,
    };
    let rows = rows(inner, values).map(|values| nested_numbers(inner, values, numbers));
    quote! { [#(#rows),*] }
}

/// Values of each array of these lengths.
fn rows<'v, T>(lengths: &[usize], values: &'v [T]) -> impl Iterator<Item = &'v [T]> {
    // `chunks` rejects a length of 0, which a robot without joints has.
    values.chunks(lengths.iter().product::<usize>().max(1))
}

/// A matrix with rows of this length, if loops copy entries of it.
fn copied(values: &[Number], columns: usize, numbers: &Numbers) -> Option<TokenStream> {
    let Numbers {
        zero,
        work,
        matrix,
        row,
        index,
        ..
    } = numbers;
    let work = work.as_ref()?;
    let rows = values.len() / columns.max(1);
    let copies = Copies::of([rows, columns], |k| Some(&values[k].value));
    if copies.loops.iter().all(|each| each.blocks.is_empty()) {
        return None;
    }
    let number = Literal::usize_unsuffixed;
    let is_zero = |value: &Value| *value == Value::Literal(0.0);
    let indices = [row, index].map(ToTokens::to_token_stream);
    let [of_rows, of_columns] = &indices;
    let loops = copies.loops.iter().filter_map(|each| {
        let of_row = subscript(each.rows.start, &[(1, of_rows)]);
        let blocks = each.blocks.iter().map(|block| {
            let down = (block.down, of_rows);
            if block.count == 1 {
                let (column, from) = (number(block.column), subscript(block.first, &[down]));
                return quote! { #matrix[#of_row][#column] = #work[#from]; };
            }
            let column = subscript(block.column, &[(1, of_columns)]);
            let from = subscript(block.first, &[down, (block.along, of_columns)]);
            let count = number(block.count);
            quote! { for #index in 0..#count { #matrix[#of_row][#column] = #work[#from]; } }
        });
        let constant = each.constant.iter().filter(|(_, value)| *value != 0.0);
        let constant = constant.map(|&(column, _)| {
            let value = &values[each.rows.start * columns + column];
            let column = number(column);
            quote! { #matrix[#of_row][#column] = #value; }
        });
        let stores: TokenStream = blocks.chain(constant).collect();
        let count = number(each.rows.len());
        (!stores.is_empty()).then(|| {
            quote! {
                #[allow(clippy::needless_range_loop)]
                for #row in 0..#count { #stores }
            }
        })
    });
    let others = copies.rest.iter().filter(|&&k| !is_zero(&values[k].value));
    let others = others.map(|&k| {
        let value = &values[k];
        let [of_row, column] = [k / columns, k % columns].map(number);
        quote! { #matrix[#of_row][#column] = #value; }
    });
    let [rows, columns] = [rows, columns].map(number);
    let mirrored = copies.is_symmetric.then(|| {
        quote! {
            #[allow(clippy::needless_range_loop)]
            for #row in 1..#rows {
                for #index in 0..#row { #matrix[#index][#row] = #matrix[#row][#index]; }
            }
        }
    });
    Some(quote! {
        {
            let mut #matrix = [[#zero; #columns]; #rows];
            #(#loops)*
            #(#others)*
            #mirrored
            #matrix
        }
    })
}

impl ToTokens for Number {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.text.to_tokens(tokens);
    }
}

/// Rows of an upper 3×4 block as `[[…]; 3], […]`.
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

fn one_or_tuple(mut items: Vec<TokenStream>) -> TokenStream {
    if items.len() == 1 {
        items.remove(0)
    } else {
        quote! { (#(#items),*) }
    }
}
