//! What a [`Builder`] makes of its options.
//!
//! In: the options. Out: tokens. It never changes an option.

use proc_macro2::TokenStream;
use quote::quote;

use super::{Builder, Origin};
use crate::description::{self, Description, inline};
use crate::error::{Errors, Place};
use crate::formulation::{Products, Sines};
use crate::print::Listing;
use crate::print::rust::{self, Item, Library, World};
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
        rust::print(listing, &self.item(listing), &self.world())
    }

    pub(super) fn item(&self, listing: &Listing) -> Item {
        let named_after = || Item::named_after(&listing.about.robot);
        self.name.clone().map_or_else(named_after, Item::made)
    }

    pub(super) fn world(&self) -> World {
        match &self.request.runtime {
            Some(path) => World::Runtime(path.clone()),
            None => World::Core(self.library()),
        }
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
        // `core` has no fused product: a price that counted on it would be wrong.
        self.listing_where(self.request.runtime.is_some())
    }

    /// What is printed where a product can fuse with a sum, or cannot.
    pub(super) fn listing_where(&self, fuses: bool) -> Result<Listing, Errors> {
        let mut errors = self.mistakes.clone();
        let loops = self.loops.iter().map(String::as_str);
        let description = match self.description(&mut errors) {
            Some(mut description) if errors.is_empty() => {
                inline::close(&mut description, loops, &mut errors);
                description
            }
            _ => return Err(errors),
        };
        if !errors.is_empty() {
            return Err(errors);
        }
        let mut request = self.request.clone();
        if request.runtime.is_none() && request.scalar == Real::Generic {
            request.scalar = Real::F64;
        }
        request.trigonometry = match (&request.runtime, self.library().sin_cos) {
            (Some(_), _) => Trigonometry::Runtime,
            (None, Some(_)) => Trigonometry::Other,
            (None, None) => Trigonometry::Own,
        };
        if !fuses && request.processor != Processor::Portable {
            request.formulation.products = Products::Unfused;
        }
        if request.batch && request.runtime.is_none() {
            let message = "batches are of the runtime: code for `core` alone has none";
            errors.push(Place::Unknown, message);
            return Err(errors);
        }
        if request.runtime.is_some() && self.library.c_prefix.is_some() {
            let message =
                "functions for C are of files that need `core` alone, without the runtime";
            errors.push(Place::Unknown, message);
            return Err(errors);
        }
        (self.expand)(&description, &request)
    }

    fn description(&self, errors: &mut Errors) -> Option<Description> {
        match &self.origin {
            Origin::File(path) => description::read_file(path, None, errors),
            Origin::Description(description) => Some((**description).clone()),
        }
    }
}
