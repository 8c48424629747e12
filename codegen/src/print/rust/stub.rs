//! Stubs after an error, so that one error in a description does not cause many more.
//!
//! In: the request, and the spaces of the robot if they are known. Out: the right signatures with bodies that
//! type-check and never run. The errors themselves are in [`Errors`](crate::error::Errors).

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::dialect::Dialect;
use super::item::{Declaration, Item};
use super::lengths::{Lengths, literal};
use super::library::Library;
use super::names::{ident, unscoped};
use super::{batch, chain, closed_loops, declaration, described, method, prepared};
use crate::function::Function;
use crate::module;
use crate::real::Real;
use crate::request::Request;
use crate::space::{ACTION, Space, Spaces};

/// Every requested method and trait, and `chain`, for a crate with the runtime.
///
/// If the description is too faulty to know the coordinates, their number is a generic parameter of each function, so
/// that calls with arrays of any length type-check.
#[must_use]
pub fn stub(item: &Item, request: &Request, spaces: Option<&Spaces>) -> TokenStream {
    let library = Library::runtime(request.runtime.as_ref());
    let dialect = Dialect::of(request.scalar, request.formulation.sines, item, &library);
    let unnamed = || ident(&dialect.names.clone().alone("N"));
    let unknown = spaces.is_none().then(unnamed);
    let lengths = |space: Space| {
        // The number of external wrenches is known from the request, and a wrench has six entries.
        match space {
            Space::Actions => return literal(request.external.len()),
            Space::Wrench => return literal(ACTION.len()),
            _ => {}
        }
        let known = spaces.map(|spaces| literal(spaces.len(space)));
        known.unwrap_or_else(|| quote! { #unknown })
    };
    // The lengths of parameter spaces need more of the description than the joints.
    let other = ident(&dialect.names.clone().alone("P"));
    let lengths = |space: Space| match space {
        Space::Coordinates | Space::Velocities | Space::Wrench | Space::Actions => lengths(space),
        _ => quote! { #other },
    };
    let parameter = unknown.as_ref().map(constant);

    let has_loops = spaces.is_some_and(|spaces| spaces.len(Space::Constraints) > 0);
    let of_functions = |item: &Item, dialect: &Dialect, batch: bool| {
        functions(
            item,
            &Request {
                batch,
                ..request.clone()
            },
            (&lengths, parameter.as_ref(), &other),
            has_loops,
            dialect,
        )
    };
    let (mut methods, mut traits) = of_functions(item, &dialect, request.batch);
    if request.prepare {
        let (prepare, beside) = prepared::absent(item, &dialect, |item, dialect| {
            of_functions(item, dialect, false)
        });
        methods.extend(absent(item, &prepare, &quote! { ::core::unreachable!() }));
        traits.extend(beside);
    }
    let wanted = request.items(has_loops).concat();
    methods.extend(data(
        item,
        request,
        &wanted,
        (&lengths, parameter.as_ref()),
        &dialect,
    ));
    traits.extend(batch::robot(item, &[], &dialect));
    if let Library::Runtime(runtime) = &dialect.library {
        let chain = chain::chain_type(
            &lengths,
            &lengths(Space::Velocities),
            &frames(request),
            runtime,
        );
        let lengths: (Lengths<'_>, _) = (&lengths, parameter.as_ref());
        traits.extend(described::absent(item, spaces, lengths, &chain, &dialect));
    }
    let declaration = match &item.declaration {
        Declaration::Written(tokens) => tokens.clone(),
        Declaration::Exists | Declaration::Made => TokenStream::new(),
    };
    let block = declaration::block(item, &methods, &dialect);
    quote! { #declaration #block #traits }
}

/// Methods and traits of the requested functions.
fn functions(
    item: &Item,
    request: &Request,
    (lengths, parameter, other): (Lengths<'_>, Option<&TokenStream>, &Ident),
    has_loops: bool,
    dialect: &Dialect,
) -> (TokenStream, TokenStream) {
    let acted = !request.external.is_empty();
    let mut methods = TokenStream::new();
    let mut traits = TokenStream::new();
    let mut names = unscoped();
    names.take("chain");
    for functions in &request.items(has_loops) {
        let frames = request.frames.iter().map(|frame| Some(frame.text.as_str()));
        for frame in [None].into_iter().chain(frames) {
            if frame.is_some() && !functions.iter().all(|function| function.of_a_frame()) {
                continue;
            }
            let name = ident(&names.fresh(&module::name(functions, frame)));
            let further = functions
                .iter()
                .any(|function| !function.further().is_empty());
            let further = further.then(|| constant(other));
            let parameters: Vec<_> = parameter.into_iter().cloned().chain(further).collect();
            let signature =
                method::signature(&name, (functions, acted), lengths, &parameters, dialect);
            let unreachable = quote! { ::core::unreachable!() };
            methods.extend(absent(item, &signature, &unreachable));
            if let ([function], None) = (functions.as_slice(), frame) {
                let batched = request.batch && function.has_batches(acted);
                if let (true, Real::Generic, Library::Runtime(runtime)) =
                    (batched, request.scalar, &dialect.library)
                {
                    let lengths: (Lengths<'_>, &[_]) = (lengths, &parameters);
                    let signature = batch::signature(*function, lengths, runtime, dialect);
                    methods.extend(absent(item, &signature, &unreachable));
                }
                traits.extend(method::implementation(
                    item,
                    *function,
                    lengths,
                    &parameters,
                    &unreachable,
                    dialect,
                ));
            }
        }
    }
    (methods, traits)
}

/// Generic parameter for a length.
fn constant(name: &Ident) -> TokenStream {
    quote! { const #name: ::core::primitive::usize }
}

/// The robot as data: a chain, a mechanism if it was requested, and base parameters.
fn data(
    item: &Item,
    request: &Request,
    wanted: &[Function],
    (lengths, parameter): (Lengths<'_>, Option<&TokenStream>),
    dialect: &Dialect,
) -> TokenStream {
    let mut data = TokenStream::new();
    if let Library::Runtime(runtime) = &dialect.library {
        let reads_fields = !request.parameters.is_empty();
        let frames = frames(request);
        let joints = lengths(Space::Velocities);
        let signature = chain::signature(
            (lengths, &joints, &frames),
            parameter,
            reads_fields,
            runtime,
        );
        // Functions that are callable in constants stay so.
        let constant = (!reads_fields).then(|| quote! { const });
        let signature = quote! { #constant #signature };
        let body = nothing(&joints, &frames, runtime);
        data.extend(absent(item, &signature, &body));
        if wanted.iter().any(|function| function.is_of_loops()) {
            let signature = closed_loops::absent(reads_fields, runtime);
            let unreachable = quote! { ::core::unreachable!() };
            data.extend(absent(item, &signature, &unreachable));
        }
    }
    if wanted.contains(&Function::BaseRegressor) {
        let number = dialect.field();
        let visibility = &item.visibility;
        data.extend(quote! {
            /// Not generated: the description has errors.
            #visibility const BASE_PARAMETERS: [#number; 0] = [];
        });
    }
    data
}

/// Number of the frames of the chain.
fn frames(request: &Request) -> TokenStream {
    literal(request.frames.len() + 1 + request.external.len())
}

fn absent(item: &Item, signature: &TokenStream, body: &TokenStream) -> TokenStream {
    let visibility = &item.visibility;
    quote! {
        /// Not generated: the description has errors.
        #visibility #signature { #body }
    }
}

/// A chain of joints and frames without content, since the compiler evaluates constants.
fn nothing(joints: &TokenStream, frames: &TokenStream, runtime: &TokenStream) -> TokenStream {
    let none = quote! { ::core::option::Option::None };
    let pose = quote! { #runtime::Pose::new([[0.0; 3]; 3], [0.0; 3]) };
    let screw = quote! { #runtime::Screw::new([0.0; 3], [0.0; 3]) };
    let inertia = quote! { #runtime::Inertia::new([0.0; 6], [0.0; 3], 0.0) };
    quote! {
        #runtime::Chain::new(
            [#runtime::Joint::new("", #none, #pose, #screw, #inertia); #joints],
            [#runtime::Frame::new("", #none, #pose); #frames],
            [0.0; 3],
        )
    }
}
