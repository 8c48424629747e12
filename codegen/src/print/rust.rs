//! Rust.
//!
//! In: a [`Module`], the struct that gets methods, and the available library. Out: tokens.

mod arguments;
mod base_parameters;
mod batch;
mod body;
mod chain;
mod closed_loops;
mod comments;
mod declaration;
mod described;
mod dialect;
mod dispatch;
mod early;
#[cfg(feature = "files")]
mod extern_c;
mod item;
#[cfg(feature = "files")]
mod lanes;
mod lengths;
mod library;
mod literals;
mod method;
pub(in crate::print) mod names;
mod prepared;
#[cfg(feature = "files")]
mod pretty;
mod results;
#[cfg(feature = "files")]
mod review;
mod roots;
mod sections;
pub(super) mod sines;
mod steps;
mod stub;
#[cfg(all(test, feature = "files"))]
pub(crate) mod tests;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::{Fields, documentation};
use crate::function::Function;
use crate::module::{GeneratedFunction, Module};
use crate::space::Order;
use dialect::Dialect;

pub use comments::header;
#[cfg(feature = "files")]
pub use extern_c::c_header;
pub use item::{Declaration, Item};
#[cfg(feature = "files")]
pub use lanes::lanes;
pub use library::{CoreFunctions, Library};
pub use method::Explained;
#[cfg(feature = "files")]
pub(crate) use names::in_every_edition;
#[cfg(feature = "files")]
pub use pretty::FormattedSource;
#[cfg(feature = "files")]
pub use review::appendix;
pub use stub::stub;

/// The struct, if it has to be declared, its methods, and items beside it: traits of `homogen::robot` with the runtime,
/// functions for C without it.
///
/// Without the runtime, [`Real::Generic`](crate::real::Real::Generic) is printed as `f64`.
#[must_use]
pub fn print(module: &Module, item: &Item, library: &Library) -> TokenStream {
    let dialect = Dialect::of(module.scalar, module.sines, item, library);
    let mut methods = TokenStream::new();
    let mut beside = TokenStream::new();
    let mut inlined = Vec::new();
    for (generated, name) in module.functions.iter().zip(names::of_methods(module)) {
        let fields = Fields::Own(&module.parameters);
        let computation =
            |dialect: &_| dispatch::computation((generated, fields), module, item, dialect);
        let own = |code: &_| method(module, item, generated, &name, (code, &dialect));
        let acted = module.spaces.actions() > 0;
        let batched = |function: Function| module.batch && function.has_batches(acted);
        match (&*generated.functions, &generated.frame, &dialect.library) {
            ([function], None, Library::Runtime(runtime)) if batched(*function) => {
                let batch = batch::Batched::new(module, item, *function, runtime, &dialect);
                methods.extend(own(&batch.call()));
                methods.extend(batch.method());
                beside.extend(batch.in_trait(&computation(&dialect.inlined())));
                inlined.push(*function);
            }
            ([function], None, _) => {
                methods.extend(own(&computation(&dialect)));
                beside.extend(method::in_trait(module, item, *function, &name, &dialect));
            }
            _ => methods.extend(own(&computation(&dialect))),
        }
    }
    methods.extend(base_parameters::base_parameters(module, item, &dialect));
    methods.extend(chain::chain(module, item, &dialect));
    methods.extend(closed_loops::closed_loops(module, item, &dialect));
    methods.extend(steps::steps(module, item, &dialect));
    let (prepare, prepared) = prepared::prepared(module, item, &dialect);
    methods.extend(prepare);
    methods.extend(dialect.own_functions(module));
    beside.extend(batch::robot(item, &inlined, &dialect));
    beside.extend(results::own_structures(module, item, &dialect));
    let declaration = declaration::declaration(module, item, &dialect);
    let described = described::described(module, item, &dialect);
    let for_c = for_c(module, item, &dialect);
    let methods = declaration::block(item, &methods, &dialect);
    quote! { #declaration #described #methods #beside #for_c #prepared }
}

/// Functions for C.
#[cfg(feature = "files")]
fn for_c(module: &Module, item: &Item, dialect: &Dialect) -> TokenStream {
    extern_c::functions(module, item, dialect)
}

/// No functions for C without the feature `files`.
#[cfg(not(feature = "files"))]
fn for_c(_: &Module, _: &Item, _: &Dialect) -> TokenStream {
    TokenStream::new()
}

/// Method of the robot with its comment.
fn method(
    module: &Module,
    item: &Item,
    generated: &GeneratedFunction,
    name: &Ident,
    computation: (&TokenStream, &Dialect),
) -> TokenStream {
    let (_, dialect) = computation;
    let about = documentation::of_function(
        module,
        generated,
        dialect
            .angles()
            .as_ref()
            .map(|angles| (angles, Order::AngularFirst)),
        None,
    );
    method::method(
        (item, &module.spaces),
        (generated, &about),
        name,
        computation,
    )
}

/// The methods of functions alone, for display.
#[must_use]
pub fn methods(module: &Module, item: &Item, library: &Library) -> TokenStream {
    let each = each_method(module, item, library).into_iter();
    each.map(|method| method.text).collect()
}

/// The same one by one, in the order of the module, each with the meanings of its names.
#[must_use]
pub fn each_method(module: &Module, item: &Item, library: &Library) -> Vec<Explained> {
    let dialect = Dialect::of(module.scalar, module.sines, item, library);
    let methods = module.functions.iter().zip(names::of_methods(module));
    methods
        .map(|(generated, name)| {
            let fields = Fields::Own(&module.parameters);
            let body = method::explained((generated, fields), module, &dialect);
            Explained {
                text: method(module, item, generated, &name, (&body.text, &dialect)),
                meanings: body.meanings,
                reads_robot: body.reads_robot,
            }
        })
        .collect()
}
