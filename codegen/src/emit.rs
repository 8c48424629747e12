//! The last stage: tokens.
//!
//! In: a [`Listing`], the programs of a robot and what is to be said about them. Out: Rust, either
//! for a crate that has the runtime ([`emit`]) or for one that has nothing but `core`
//! ([`standalone`]). It never computes a number, changes an operation or chooses an order.

mod body;
mod c;
mod chain;
mod dialect;
mod documentation;
mod item;
mod lengths;
mod literals;
mod method;
mod names;
#[cfg(feature = "pretty")]
mod pretty;
mod results;
mod sines;
mod stub;
#[cfg(all(test, feature = "pretty"))]
pub(crate) mod tests;

use proc_macro2::TokenStream;
use quote::quote;

use crate::accuracy::Accuracy;
use crate::formulation::Sines;
use crate::function::Function;
use crate::real::Real;
use crate::request::Parameter;
use crate::schedule::{Price, Program};
use crate::space::Spaces;
use dialect::Dialect;
use names::ident;

pub use c::c_header;
pub use dialect::Library;
pub use documentation::header;
pub use item::{Declaration, Item};
pub use names::type_name;
#[cfg(feature = "pretty")]
pub use pretty::Source;
pub use stub::{Wanted, stub};

/// Everything that is printed for one robot.
#[derive(Clone)]
pub struct Listing {
    /// The struct that the functions become methods of.
    pub item: Item,
    /// What the doc comments say.
    pub about: About,
    /// What arguments and results are over.
    pub spaces: Spaces,
    /// The functions, in the order of the request.
    pub functions: Vec<Listed>,
    /// The robot as data.
    pub data: ChainData,
    /// The type of number.
    pub scalar: Real,
    /// Where sines and cosines come from.
    pub sines: Sines,
    /// The struct's fields that programs read, in the order in which
    /// [`Input::Parameter`](crate::expression::Input) counts them.
    pub parameters: Vec<Parameter>,
    /// The path of the runtime crate; `::homogen` where none.
    pub runtime: Option<TokenStream>,
    /// The absolute path of the file whose change makes the compiler expand again; none where the
    /// door has other means.
    pub watched: Option<String>,
}

/// What a doc comment says about a robot.
#[derive(Clone, Debug, Default)]
pub struct About {
    /// The robot's name.
    pub robot: String,
    /// The name of the file it was read from, without folders, and the hash of its bytes.
    pub source: Option<(String, u64)>,
    /// The link whose frame is frame 0.
    pub base: String,
    /// The link whose frame poses and Jacobians are of.
    pub tip: String,
    /// What is modelled and what is not: `2 links merged`, `gravity only along −z`.
    pub facts: Vec<String>,
    /// The words of the formulation that was asked for, where it is not the default.
    pub formulation: Vec<String>,
    /// Doubts about the description, each a sentence with its place.
    pub warnings: Vec<String>,
    /// Functions that the robot cannot have, where all that it can have were asked for.
    pub left_out: Vec<LeftOut>,
}

/// Functions that a robot cannot have, for one reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// The names of their methods.
    pub functions: Vec<String>,
    /// Why, a sentence with its place.
    pub reason: String,
    /// What to do about it.
    pub hint: Option<String>,
}

/// One generated method.
#[derive(Clone, Debug)]
pub struct Listed {
    /// What it computes; several functions share their work and are returned as a tuple.
    pub functions: Vec<Function>,
    /// The link whose frame it is about, where that is not the tip.
    pub frame: Option<String>,
    /// The operations.
    pub program: Program,
    /// What they cost.
    pub price: Price,
    /// How far rounding can take their results: those that are evaluated, and each that solves
    /// something.
    pub accuracy: Vec<Accuracy>,
}

impl Listed {
    /// The name of the method, as far as nothing else is called so.
    #[must_use]
    pub fn name(&self) -> String {
        method::name(&self.functions, self.frame.as_deref())
    }
}

/// A robot as data for the generic recursions of the runtime.
#[derive(Clone, Debug)]
pub struct ChainData {
    /// The joints' names in the order of q.
    pub names: Vec<String>,
    /// The joint that carries the link on which each joint hangs; none where that is the base.
    pub parents: Vec<Option<u16>>,
    /// Further frames, the tip's first: name, and the joint that carries it.
    pub frames: Vec<(String, Option<u16>)>,
    /// The numbers, of parameters only. A joint has 28: placement at q = 0 in its parent's frame
    /// (rows of the upper 3×4 block), screw (u, b), pseudo-inertia (xx, yy, zz, xy, xz, yz, the
    /// first moments qx, qy, qz, and m). A frame has 12, its placement. Gravity comes last, 3.
    pub program: Program,
}

/// The methods of a robot for a crate that depends on the runtime, with the traits of
/// `homogen::robot` beside them.
#[must_use]
pub fn emit(listing: &Listing) -> TokenStream {
    let dialect = Dialect::of_runtime(listing);
    let (declaration, methods, traits) = parts(listing, &dialect, Some(&dialect));
    let watch = listing.watched.as_ref().map(|path| {
        quote! { const _: &[::core::primitive::u8] = ::core::include_bytes!(#path); }
    });
    quote! { #declaration #methods #traits #watch }
}

/// The methods that [`emit`] writes, alone: without struct, traits and data, to be read.
#[must_use]
pub fn methods(listing: &Listing) -> TokenStream {
    let dialect = Dialect::of_runtime(listing);
    let mut names = names::unscoped();
    let methods = listing.functions.iter().map(|listed| {
        let name = names.fresh(&listed.name());
        method::method(listing, listed, &ident(&name), &dialect)
    });
    methods.collect()
}

/// The methods of a robot for a crate that has nothing but `core`: results are arrays, and there are
/// no traits. [`Real::Generic`] is taken for `f64`.
#[must_use]
pub fn standalone(listing: &Listing, library: &Library) -> TokenStream {
    let dialect = Dialect::of_core(listing, library);
    let (declaration, methods, _) = parts(listing, &dialect, None);
    let prefix = library.c_prefix.as_deref();
    let for_c = prefix.map(|prefix| c::functions(listing, prefix, &dialect));
    quote! { #declaration #methods #for_c }
}

/// The struct, the block of its methods, and the traits; `chain()` and the traits only where
/// there is a runtime.
fn parts(
    listing: &Listing,
    dialect: &Dialect,
    runtime: Option<&Dialect>,
) -> (TokenStream, TokenStream, TokenStream) {
    let mut methods = TokenStream::new();
    let mut traits = TokenStream::new();
    for (listed, name) in listing.functions.iter().zip(method::names(listing)) {
        methods.extend(method::method(listing, listed, &name, dialect));
        if let ([function], None, Some(_)) = (&*listed.functions, &listed.frame, runtime) {
            traits.extend(method::in_trait(listing, *function, &name, dialect));
        }
    }
    if runtime.is_some() {
        methods.extend(chain::chain(listing, dialect));
    }
    methods.extend(dialect.own_sines(listing));
    let declaration = item::declaration(listing, dialect);
    let methods = item::block(&listing.item, &methods, dialect);
    (declaration, methods, traits)
}
