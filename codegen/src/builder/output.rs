//! What a [`Builder`] makes of its options.
//!
//! In: the options. Out: tokens, text, a file in `OUT_DIR`. It never changes an option.

use proc_macro2::{Ident, Span, TokenStream};

use super::{Builder, Origin};
use crate::description::{self, Description};
use crate::emit::{self, Item, Library, Listing};
use crate::error::{Errors, Place};
use crate::request::Real;

impl Builder {
    /// The struct and its methods.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request.
    pub fn to_tokens(&self) -> Result<TokenStream, Errors> {
        Ok(self.print(&self.listing()?))
    }

    fn print(&self, listing: &Listing) -> TokenStream {
        if self.request.runtime.is_some() {
            return emit::emit(listing);
        }
        let mut library = Library::libm(listing.scalar);
        if let Some(sin_cos) = &self.sin_cos {
            library.sin_cos.clone_from(sin_cos);
        }
        if let Some(sqrt) = &self.sqrt {
            library.sqrt.clone_from(sqrt);
        }
        emit::standalone(listing, &library)
    }

    fn listing(&self) -> Result<Listing, Errors> {
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
        (self.expand)(&description, &request, item)
    }

    fn description(&self, errors: &mut Errors) -> Option<Description> {
        match &self.origin {
            Origin::File(path) => description::read_file(path, None, errors),
            Origin::Description(description) => Some((**description).clone()),
        }
    }
}

#[cfg(feature = "pretty")]
impl Builder {
    /// The same as [`Builder::to_tokens`], formatted, under a head that tells origin, options and
    /// prices.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request.
    pub fn to_source(&self) -> Result<emit::Source, Errors> {
        self.listing().map(|listing| self.source(&listing))
    }

    /// Writes [`Builder::to_source`] to a file in `OUT_DIR`, and tells cargo which file to watch
    /// and what is doubtful about it.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request, each of which cargo shows; a file
    /// that cannot be written.
    pub fn write(&self, file: impl AsRef<std::path::Path>) -> Result<(), Errors> {
        if let Origin::File(path) = &self.origin {
            println!("cargo::rerun-if-changed={}", path.display());
        }
        let written = self.listing().and_then(|listing| {
            for warning in &listing.about.warnings {
                println!("cargo::warning={warning}");
            }
            write(file.as_ref(), &self.source(&listing))
        });
        if let Err(errors) = &written {
            for line in errors.to_string().lines() {
                println!("cargo::error={}", line.trim_start_matches("error: "));
            }
        }
        written
    }

    fn source(&self, listing: &Listing) -> emit::Source {
        let header = emit::header(listing, &self.options());
        emit::Source::new(header, &self.print(listing))
    }

    /// What was asked for, as the command line would say it.
    fn options(&self) -> String {
        let request = &self.request;
        let number = match (request.scalar, &request.runtime) {
            (Real::F32, _) => "f32",
            (Real::Generic, Some(_)) => "any scalar",
            (Real::F64 | Real::Generic, _) => "f64",
        };
        let mut options = vec![number.to_owned()];
        options.extend(
            request
                .base
                .iter()
                .map(|link| format!("base {}", link.text)),
        );
        options.extend(request.tip.iter().map(|link| format!("tip {}", link.text)));
        options.extend(request.path_only.then(|| "path only".to_owned()));
        options.extend(request.lock.iter().map(|(joint, at)| {
            let at = at.map_or(0.0, |at| at.value);
            format!("lock {}={at:?}", joint.text)
        }));
        options.extend(
            request
                .drop
                .iter()
                .map(|link| format!("drop {}", link.text)),
        );
        options.extend(request.gravity.map(|gravity| {
            let gravity = gravity.map(|number| number.value);
            format!("gravity {gravity:?}")
        }));
        options.extend(request.exact.then(|| "exact".to_owned()));
        options.extend(request.strict.then(|| "strict".to_owned()));
        options.join(", ")
    }
}

#[cfg(feature = "pretty")]
fn write(file: &std::path::Path, source: &emit::Source) -> Result<(), Errors> {
    let refuse = |message: String| {
        let mut errors = Errors::new();
        errors.push(Place::Unknown, message);
        errors
    };
    let folder = std::env::var_os("OUT_DIR")
        .ok_or_else(|| refuse("OUT_DIR is not set: this is for build scripts".to_owned()))?;
    let path = std::path::Path::new(&folder).join(file);
    std::fs::write(&path, source.to_string())
        .map_err(|reason| refuse(format!("cannot write {}: {reason}", path.display())))
}
