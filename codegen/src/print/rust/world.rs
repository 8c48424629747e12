//! What generated code finds around it.
//!
//! In: the choice of a door. Out: the paths that the code may call. It never knows a robot.

use proc_macro2::TokenStream;
use quote::quote;

use crate::print::documentation::Angles;
use crate::real::Real;

/// What generated code can rely on.
#[derive(Clone, Debug)]
pub enum World {
    /// The runtime crate, at this path: results are typed matrices, and there are traits.
    Runtime(TokenStream),
    /// Nothing but `core` and these functions: results are arrays.
    Core(Library),
    /// At this path a trait `number::Number`, of numbers alone or side by side, and functions of single
    /// joints in `posture`: arguments and results are arrays without arrays within them.
    Lanes(TokenStream),
}

/// What code without the runtime finds and leaves around it.
#[derive(Clone, Debug, Default)]
pub struct Library {
    /// A function from an angle to its sine and cosine, as a pair; where none is named, the struct
    /// gets one of its own.
    pub sin_cos: Option<TokenStream>,
    /// How the names of functions for C begin; there are none where this is not given.
    pub c_prefix: Option<String>,
}

impl World {
    /// The runtime at a path, or where it usually is.
    #[must_use]
    pub fn runtime(path: Option<&TokenStream>) -> Self {
        path.map_or_else(Self::default, |path| Self::Runtime(path.clone()))
    }
}

impl Default for World {
    /// The runtime at `::homogen`.
    fn default() -> Self {
        Self::Runtime(quote! { ::homogen })
    }
}

impl Library {
    /// For which angles its sines and cosines are precise.
    pub(super) fn angles(&self, real: Real) -> Angles {
        match &self.sin_cos {
            None => Angles::own(real),
            Some(path) => Angles::As(spelled(path)),
        }
    }
}

/// A path as people write it.
pub(super) fn spelled(path: &TokenStream) -> String {
    path.to_string().replace(' ', "")
}
