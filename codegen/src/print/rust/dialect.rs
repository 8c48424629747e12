//! Dialects: differences between code for the runtime and code for `core` alone.
//!
//! In: the scalar type, a struct and the available library. Out: the text of literals, types and mathematical
//! functions, so that the printers of statements are the same for all dialects.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote, quote_spanned};

use super::item::{Declaration, Item};
use super::library::Library;
use super::literals::Numerals;
use super::names::{SIN_COS, ident};
use super::roots::{self, SQRT};
use super::sines;
use crate::formulation::Sines;
use crate::module::Module;
use crate::print::documentation::SineAngles;
use crate::print::steps::{has_angles, has_roots};
use crate::real::Real;
use crate::schedule::{LONGEST_SCOPE, Names};
use crate::space::Variable;

/// Maximum number of sines and cosines in one statement; more are split for readability.
const ON_ONE_LINE: usize = 4;

/// Names of equations that are compiled for several kinds of processor.
#[derive(Clone, Debug)]
pub(super) struct Equations {
    /// The robot, which they are no method of.
    pub robot: Ident,
    /// The struct with their arguments.
    pub name: Ident,
    /// The generic parameter for the rounding of their products.
    pub rounding: Ident,
    /// True if they have the same bits on every processor.
    pub reproducible: bool,
}

/// Dialect of one output.
#[derive(Clone, Debug)]
pub(super) struct Dialect {
    /// Available library.
    pub library: Library,
    /// Scalar type.
    pub number: TokenStream,
    /// Generic parameter for the scalar type, if it is generic.
    generic: Option<Ident>,
    /// Scalar type by name.
    pub real: Real,
    /// Struct with the fields; other items are named after it.
    pub robot: Ident,
    /// True if the struct is generic over the scalar type, and not each function.
    prepared: bool,
    /// Names that functions cannot bind.
    pub names: Names,
    /// Source of sines and cosines.
    sines: Sines,
    /// True if functions are inlined and convert literals by means of an argument.
    inlined: bool,
    /// True if the type of every literal is known from its context.
    bare: bool,
    /// Type of the struct's fields, unless the user declared them.
    fields: Option<Real>,
    /// Names of equations that are compiled for several kinds of processor.
    pub equations: Option<Equations>,
    /// States that a number holds.
    pub states: StateCount,
}

/// States that a number holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StateCount {
    /// One, or any number that a generic type holds.
    One,
    /// Several, in a pack or a vector.
    Several,
}

impl Dialect {
    /// Dialect of a struct; without the runtime [`Real::Generic`] is printed as `f64`.
    pub fn of(scalar: Real, sines: Sines, item: &Item, library: &Library) -> Self {
        let real = match (library, scalar) {
            (Library::Core(_), Real::Generic) => Real::F64,
            (_, real) => real,
        };
        let made = matches!(item.declaration, Declaration::Made);
        let mut names = item.names();
        let is_generic = real == Real::Generic || matches!(library, Library::Lanes(_));
        let generic = is_generic.then(|| ident(&names.alone("T")));
        let number = match (&generic, library, real) {
            (Some(generic), _, _) => quote! { #generic },
            (None, Library::Runtime(_), Real::F32) => quote! { ::core::primitive::f32 },
            (None, Library::Runtime(_), _) => quote! { ::core::primitive::f64 },
            (None, _, Real::F32) => quote! { f32 },
            (None, _, _) => quote! { f64 },
        };
        Self {
            library: library.clone(),
            robot: item.ident.clone(),
            prepared: false,
            number,
            generic,
            real,
            names,
            sines,
            inlined: false,
            bare: false,
            fields: made.then_some(real),
            equations: None,
            states: match library {
                Library::Lanes(_) => StateCount::Several,
                Library::Runtime(_) | Library::Core(_) => StateCount::One,
            },
        }
    }

    /// Name of a local variable: not that of a struct without fields, which would be a pattern.
    pub fn local(&self, wish: &str) -> Ident {
        ident(&self.names.clone().alone(wish))
    }

    /// Name of an argument.
    pub fn argument(&self, argument: Variable) -> Ident {
        self.local(argument.name())
    }

    /// Generic parameter of a function with its bound.
    pub fn bound(&self) -> Option<TokenStream> {
        match (&self.generic, &self.library) {
            (Some(_), _) if self.prepared => None,
            (Some(generic), Library::Runtime(runtime)) => {
                Some(quote! { #generic: #runtime::Scalar })
            }
            (Some(generic), Library::Lanes(path)) => {
                Some(quote! { #generic: #path::number::Number })
            }
            _ => None,
        }
    }

    /// The same for a function within another.
    pub fn bound_inside(&self) -> Option<TokenStream> {
        let inside = Self {
            prepared: false,
            ..self.clone()
        };
        inside.bound()
    }

    /// True if the struct has C layout.
    pub fn is_for_c(&self) -> bool {
        matches!(&self.library, Library::Core(core_functions) if core_functions.c_prefix.is_some())
    }

    /// Angles for which functions are accurate; `None` with the runtime, which documents them.
    pub fn angles(&self) -> Option<SineAngles> {
        match &self.library {
            Library::Runtime(_) | Library::Lanes(_) => None,
            Library::Core(core_functions) => Some(core_functions.angles(self.real)),
        }
    }

    /// Dialect of a prepared robot, whose fields have the scalar type of the functions.
    pub fn of_prepared(&self) -> Self {
        Self {
            prepared: true,
            ..self.clone()
        }
    }

    /// Dialect of functions that are inlined into their callers.
    pub fn inlined(&self) -> Self {
        Self {
            inlined: true,
            ..self.clone()
        }
    }

    /// Dialect of equations that are compiled for several kinds of processor, with the runtime.
    pub fn of_equations(&self, reproducible: bool) -> Self {
        if !matches!(self.library, Library::Runtime(_)) {
            return self.clone();
        }
        let mut names = self.names.clone();
        let [robot, name, rounding] =
            ["robot", "Equations", "R"].map(|wish| ident(&names.alone(wish)));
        Self {
            names,
            equations: Some(Equations {
                robot,
                name,
                rounding,
                reproducible,
            }),
            ..self.clone()
        }
    }

    /// Dialect of the same equations on packs of several states.
    pub fn of_packs(&self) -> Self {
        Self {
            states: StateCount::Several,
            ..self.clone()
        }
    }

    /// The robot in a function.
    pub fn this(&self) -> TokenStream {
        let robot = self.equations.as_ref().map(|equations| &equations.robot);
        robot.map_or_else(|| quote! { self }, ToTokens::to_token_stream)
    }

    /// Dialect of the robot as data, in `f64`.
    pub fn of_data(&self) -> Self {
        Self {
            number: quote! { ::core::primitive::f64 },
            generic: None,
            real: Real::F64,
            bare: true,
            ..self.clone()
        }
    }

    /// Type of a number in a struct field.
    pub fn field(&self) -> TokenStream {
        match (&self.library, self.real) {
            (Library::Runtime(_), Real::Generic) => quote! { ::core::primitive::f64 },
            (Library::Lanes(_), _) => quote! { f64 },
            _ => self.number.clone(),
        }
    }

    /// Function that makes literals like a number, where functions are inlined and their numbers may be registers.
    pub fn like(&self, number: &TokenStream) -> Option<TokenStream> {
        let (Some(_), Library::Runtime(runtime), true) =
            (&self.generic, &self.library, self.inlined)
        else {
            return None;
        };
        let value = self.local("number");
        Some(quote! { |#value| #runtime::Scalar::like(#number, #value) })
    }

    /// Form of literals, and the statement that they need in a function with this first argument.
    pub fn numerals(&self, first: Option<&Ident>, names: &mut Names) -> (Numerals, TokenStream) {
        let value = self.local("number");
        let like = first.and_then(|first| self.like(&quote! { #first[0] }));
        let made = match (&self.generic, &self.library, first) {
            (Some(number), Library::Runtime(runtime), _) => {
                like.unwrap_or_else(|| quote! { <#number as #runtime::Scalar>::constant })
            }
            (Some(_), Library::Lanes(path), Some(first)) => {
                quote! { |#value| #path::number::Number::like(#first[0], #value) }
            }
            (_, _, _) if self.bare => return (Numerals::Bare, TokenStream::new()),
            (_, _, _) if self.real == Real::F32 => return (Numerals::Single, TokenStream::new()),
            (_, _, _) => return (Numerals::Double, TokenStream::new()),
        };
        let k = ident(&names.fresh("k"));
        let statement = quote! { let #k = #made; };
        (Numerals::Through(k), statement)
    }

    /// Conversion of a field's number to the scalar type.
    pub fn converted(&self, numerals: &Numerals, value: &TokenStream, span: Span) -> TokenStream {
        let number = &self.number;
        let double = match self.fields {
            Some(Real::F64 | Real::Generic) => value.clone(),
            Some(Real::F32) | None => quote_spanned! {span=>
                <::core::primitive::f64 as ::core::convert::From<_>>::from(#value)
            },
        };
        match (&self.library, numerals, self.real) {
            (Library::Core(_), _, _) => value.clone(),
            (Library::Lanes(_), Numerals::Through(k), _) => quote! { #k(#value) },
            (_, _, Real::F32) if self.fields == Some(Real::F32) => value.clone(),
            // By way of f64, so that a field may have either type; the conversion to f64 and back is exact.
            (Library::Runtime(runtime), _, Real::F32) => {
                quote! { <#number as #runtime::Scalar>::constant(#double) }
            }
            (_, Numerals::Through(k), _) => quote! { #k(#double) },
            (_, _, _) => double,
        }
    }

    /// Name of the fused product in a function that has one, and the statement that binds it.
    pub fn fused(&self, names: &mut Names) -> (Option<Ident>, TokenStream) {
        let number = &self.number;
        match &self.library {
            Library::Runtime(runtime) => {
                let name = ident(&names.fresh("mul_add"));
                let function = if let Some(Equations { rounding, .. }) = &self.equations {
                    quote! { #rounding::mul_add::<#number> }
                } else {
                    quote! { <#number as #runtime::Scalar>::mul_add }
                };
                (Some(name.clone()), quote! { let #name = #function; })
            }
            Library::Core(_) | Library::Lanes(_) => (None, TokenStream::new()),
        }
    }

    /// √a.
    pub fn sqrt(&self, a: &TokenStream) -> TokenStream {
        match &self.library {
            Library::Runtime(runtime) => quote! { #runtime::Scalar::sqrt(#a) },
            Library::Lanes(path) => quote! { #path::number::Number::sqrt(#a) },
            Library::Core(_) => {
                let (owner, sqrt) = (self.owner(), ident(SQRT));
                quote! { #owner::#sqrt(#a) }
            }
        }
    }

    /// −1, 0 or 1 without a branch: `core` has no `signum` before Rust 1.85, and that is never 0.
    pub fn sign(&self, a: &TokenStream) -> TokenStream {
        let number = &self.number;
        match &self.library {
            Library::Runtime(runtime) => quote! { #runtime::Scalar::sign(#a) },
            Library::Lanes(path) => quote! { #path::number::Number::sign(#a) },
            Library::Core(_) => quote! { #number::from(i8::from(#a > 0.0) - i8::from(#a < 0.0)) },
        }
    }

    /// Statements that bind all sines and cosines; at least one.
    pub fn sines_and_cosines(
        &self,
        sines: &[TokenStream],
        cosines: &[TokenStream],
        angles: &[TokenStream],
        names: &mut Names,
    ) -> TokenStream {
        let number = match &self.library {
            Library::Runtime(runtime) => quote! { #runtime::Scalar },
            Library::Lanes(path) => quote! { #path::number::Number },
            Library::Core(_) => TokenStream::new(),
        };
        let together = match &self.equations {
            Some(Equations { rounding, .. }) => rounding.to_token_stream(),
            None => number.clone(),
        };
        match &self.library {
            Library::Runtime(_) | Library::Lanes(_) if self.sines == Sines::Platform => {
                one_by_one(&quote! { #number::sin_cos }, sines, cosines, angles)
            }
            Library::Runtime(_) | Library::Lanes(_) if angles.len() <= ON_ONE_LINE => quote! {
                let ([#(#sines),*], [#(#cosines),*]) = #together::sin_cos_all([#(#angles),*]);
            },
            Library::Runtime(_) | Library::Lanes(_) => {
                let [a, s, c] =
                    ["angles", "sines", "cosines"].map(|name| ident(&names.fresh(name)));
                quote! {
                    let #a = [#(#angles),*];
                    let (#s, #c) = #together::sin_cos_all(#a);
                    let [#(#sines),*] = #s;
                    let [#(#cosines),*] = #c;
                }
            }
            Library::Core(core_functions) => {
                let own = ident(SIN_COS);
                let sin_cos = core_functions.sin_cos.clone();
                let owner = self.owner();
                let sin_cos = sin_cos.unwrap_or_else(|| quote! { #owner::#own });
                one_by_one(&sin_cos, sines, cosines, angles)
            }
        }
    }

    /// The struct with private functions.
    fn owner(&self) -> TokenStream {
        if self.prepared {
            self.robot.to_token_stream()
        } else {
            quote! { Self }
        }
    }

    /// Private functions of the struct: sines and cosines if programs have angles, and the square root.
    pub fn own_functions(&self, module: &Module) -> TokenStream {
        let Library::Core(core_functions) = &self.library else {
            return TokenStream::new();
        };
        let sines = has_angles(module) && core_functions.sin_cos.is_none();
        let sines = sines.then(|| sines::function(self.real, &self.robot));
        let root = has_roots(module).then(|| roots::function(self.real, &self.robot));
        quote! { #sines #root }
    }
}

/// Sines and cosines by a function of one angle; in a single binding if there are more than a scope may have.
fn one_by_one(
    sin_cos: &TokenStream,
    sines: &[TokenStream],
    cosines: &[TokenStream],
    angles: &[TokenStream],
) -> TokenStream {
    if angles.len() > LONGEST_SCOPE {
        return quote! { let [#((#sines, #cosines)),*] = [#(#sin_cos(#angles)),*]; };
    }
    quote! { #(let (#sines, #cosines) = #sin_cos(#angles);)* }
}
