//! How long arrays are, as types have it.
//!
//! In: the spaces of a robot, or as much as is known of them. Out: a length for each space.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::space::{Space, Spaces};

/// A length for each space.
pub(super) struct Lengths {
    coordinates: TokenStream,
    velocities: TokenStream,
}

impl Lengths {
    /// Of spaces that are known.
    pub fn of_spaces(spaces: &Spaces) -> Self {
        Self {
            coordinates: number(spaces.len(Space::Coordinates)),
            velocities: number(spaces.len(Space::Velocities)),
        }
    }

    /// The same for all.
    pub fn all(length: &TokenStream) -> Self {
        Self {
            coordinates: length.clone(),
            velocities: length.clone(),
        }
    }

    /// Of one space.
    pub fn of(&self, space: Space) -> TokenStream {
        match space {
            Space::Coordinates => self.coordinates.clone(),
            Space::Velocities => self.velocities.clone(),
        }
    }
}

/// A length that is known.
pub(super) fn number(length: usize) -> TokenStream {
    let length = Literal::usize_unsuffixed(length);
    quote! { #length }
}
