//! Libraries that generated code may use.
//!
//! In: the choice of a front end. Out: the paths that the code may call.

use proc_macro2::TokenStream;
use quote::quote;

use crate::print::documentation::SineAngles;
use crate::real::Real;

/// Library that generated code may use.
#[derive(Clone, Debug)]
pub enum Library {
    /// The runtime crate at this path: results are matrix types, and there are traits.
    Runtime(TokenStream),
    /// `core` and these functions: results are arrays.
    Core(CoreFunctions),
    /// A crate at this path with a trait `number::Number`, for scalars and vectors, and functions of single joints in
    /// `robot::manifold`: arguments and results are flat arrays.
    Lanes(TokenStream),
}

/// Functions around code without the runtime.
#[derive(Clone, Debug, Default)]
pub struct CoreFunctions {
    /// Function from an angle to its sine and cosine as a pair; without it, the struct gets a private one.
    pub sin_cos: Option<TokenStream>,
    /// Prefix of functions for C; `None` for no such functions.
    pub c_prefix: Option<String>,
}

impl Library {
    /// The runtime at a path, or at the default one.
    #[must_use]
    pub fn runtime(path: Option<&TokenStream>) -> Self {
        path.map_or_else(Self::default, |path| Self::Runtime(path.clone()))
    }
}

impl Default for Library {
    /// The runtime at `::homogen`.
    fn default() -> Self {
        Self::Runtime(quote! { ::homogen })
    }
}

impl CoreFunctions {
    /// Angles for which its sines and cosines are accurate.
    pub(super) fn angles(&self, real: Real) -> SineAngles {
        match &self.sin_cos {
            None => SineAngles::own(real),
            Some(path) => SineAngles::As(spelled(path)),
        }
    }
}

/// Path as people write it.
pub(super) fn spelled(path: &TokenStream) -> String {
    path.to_string().replace(' ', "")
}
