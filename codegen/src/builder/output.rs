//! What a [`Builder`] makes of its options.
//!
//! In: the options. Out: tokens. It never changes an option.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::{Builder, Origin};
use crate::description::{self, Description};
use crate::emit::{self, Item, Library, Listing};
use crate::error::{Errors, Place};
use crate::formulation::{Products, Sines};
use crate::processor::Processor;
use crate::real::{Real, Trigonometry};

impl Builder {
    /// The struct and its methods.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request.
    pub fn to_tokens(&self) -> Result<TokenStream, Errors> {
        Ok(self.print(&self.listing()?))
    }

    pub(super) fn print(&self, listing: &Listing) -> TokenStream {
        if self.request.runtime.is_some() {
            return emit::emit(listing);
        }
        emit::standalone(listing, &self.library())
    }

    /// What code without the runtime calls. `core` has no sines: those of the platform are of the
    /// crate `libm`.
    pub(super) fn library(&self) -> Library {
        let mut library = self.library.clone();
        if self.request.formulation.sines == Sines::Platform && library.sin_cos.is_none() {
            library.sin_cos = Some(match self.request.scalar {
                Real::F32 => quote! { ::libm::sincosf },
                Real::F64 | Real::Generic => quote! { ::libm::sincos },
            });
        }
        library
    }

    pub(crate) fn listing(&self) -> Result<Listing, Errors> {
        let mut errors = self.mistakes.clone();
        let description = match self.description(&mut errors) {
            Some(description) if errors.is_empty() => description,
            _ => return Err(errors),
        };
        let name = || Ident::new(&emit::type_name(&description.name.text), Span::call_site());
        let item = Item::made(self.name.clone().unwrap_or_else(name));
        let mut request = self.request.clone();
        if request.runtime.is_none() && request.scalar == Real::Generic {
            request.scalar = Real::F64;
        }
        request.trigonometry = match (&request.runtime, self.library().sin_cos) {
            (Some(_), _) => Trigonometry::Runtime,
            (None, Some(_)) => Trigonometry::Other,
            (None, None) => Trigonometry::Own,
        };
        // `core` has no fused product: a price that counted on it would be wrong.
        if request.runtime.is_none() && request.processor != Processor::Portable {
            request.formulation.products = Products::Unfused;
        }
        if request.runtime.is_some() && self.library.c_prefix.is_some() {
            let message =
                "functions for C are of files that need `core` alone, without the runtime";
            errors.push(Place::Unknown, message);
            return Err(errors);
        }
        (self.expand)(&description, &request, item)
    }

    fn description(&self, errors: &mut Errors) -> Option<Description> {
        match &self.origin {
            Origin::File(path) => description::read_file(path, None, errors),
            Origin::Description(description) => Some((**description).clone()),
        }
    }
}
