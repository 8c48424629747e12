//! Rust.
//!
//! In: a [`Listing`], the struct that gets methods, and what the code finds around it. Out: tokens.
//! It never names a value of a program: that is done before.

mod arguments;
mod base_parameters;
mod batch;
mod body;
mod chain;
mod comments;
mod declaration;
mod dialect;
mod early;
mod extern_c;
mod item;
mod lanes;
mod lengths;
mod literals;
mod mechanism;
mod method;
pub(in crate::print) mod names;
mod prepared;
#[cfg(feature = "pretty")]
mod pretty;
mod results;
mod review;
mod sections;
pub(super) mod sines;
mod steps;
mod stub;
#[cfg(all(test, feature = "pretty"))]
pub(crate) mod tests;
mod world;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::{Fields, Listed, Listing, documentation};
use dialect::Dialect;

pub use comments::header;
pub use extern_c::c_header;
pub use item::{Declaration, Item};
pub use lanes::lanes;
#[cfg(feature = "pretty")]
pub(super) use lanes::under;
pub(crate) use names::in_every_edition;
#[cfg(feature = "pretty")]
pub use pretty::Source;
pub use review::appendix;
pub use stub::stub;
pub use world::{Library, World};

/// The struct, where it has to be declared, its methods, and what stands beside them: with the
/// runtime the traits of `homogen::robot`, without it the functions for C.
///
/// Without the runtime, [`Real::Generic`](crate::real::Real::Generic) is taken for `f64`.
#[must_use]
pub fn print(listing: &Listing, item: &Item, world: &World) -> TokenStream {
    let dialect = Dialect::of(listing.scalar, listing.sines, item, world);
    let mut methods = TokenStream::new();
    let mut beside = TokenStream::new();
    for (listed, name) in listing.functions.iter().zip(names::of_methods(listing)) {
        let fields = Fields::Own(&listing.parameters);
        let computation = |dialect: &_| method::computation((listed, fields), listing, dialect);
        let own = |code: &_| method(listing, item, listed, &name, (code, &dialect));
        let acted = listing.spaces.actions() > 0;
        let batched =
            |function: crate::function::Function| listing.batch && function.has_batches(acted);
        match (&*listed.functions, &listed.frame, &dialect.world) {
            ([function], None, World::Runtime(runtime)) if batched(*function) => {
                let batch = batch::Batched::new(listing, item, *function, runtime, &dialect);
                methods.extend(own(&batch.call()));
                methods.extend(batch.method());
                beside.extend(batch.in_trait(&computation(&dialect.inlined())));
            }
            ([function], None, _) => {
                methods.extend(own(&computation(&dialect)));
                beside.extend(method::in_trait(listing, item, *function, &name, &dialect));
            }
            _ => methods.extend(own(&computation(&dialect))),
        }
    }
    methods.extend(base_parameters::base_parameters(listing, item, &dialect));
    methods.extend(chain::chain(listing, item, &dialect));
    methods.extend(mechanism::mechanism(listing, item, &dialect));
    methods.extend(steps::steps(listing, item, &dialect));
    let (prepare, prepared) = prepared::prepared(listing, item, &dialect);
    methods.extend(prepare);
    methods.extend(dialect.own_sines(listing));
    beside.extend(results::own_structures(listing, item, &dialect));
    beside.extend(extern_c::functions(listing, item, &dialect));
    let declaration = declaration::declaration(listing, item, &dialect);
    let constants = review::constants(listing, item, &dialect);
    let methods = declaration::block(item, &methods, &dialect);
    quote! { #declaration #constants #methods #beside #prepared }
}

/// A method of the robot, under what there is to say of it.
fn method(
    listing: &Listing,
    item: &Item,
    listed: &Listed,
    name: &Ident,
    computation: (&TokenStream, &Dialect),
) -> TokenStream {
    let (_, dialect) = computation;
    let about = documentation::of_function(listing, listed, dialect.angles().as_ref(), None);
    method::method((item, &listing.spaces), (listed, &about), name, computation)
}

/// The methods that [`print()`] writes for functions, alone, to be read.
#[must_use]
pub fn methods(listing: &Listing, item: &Item, world: &World) -> TokenStream {
    each_method(listing, item, world).into_iter().collect()
}

/// The same one by one, in the order of the listing.
#[must_use]
pub fn each_method(listing: &Listing, item: &Item, world: &World) -> Vec<TokenStream> {
    let dialect = Dialect::of(listing.scalar, listing.sines, item, world);
    let methods = listing.functions.iter().zip(names::of_methods(listing));
    methods
        .map(|(listed, name)| {
            let fields = Fields::Own(&listing.parameters);
            let body = method::computation((listed, fields), listing, &dialect);
            method(listing, item, listed, &name, (&body, &dialect))
        })
        .collect()
}
