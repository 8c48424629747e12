//! From the options of a [`Builder`] to its module and tokens.

use std::path::Path;

use proc_macro2::TokenStream;
use quote::quote;
use syn::ext::IdentExt;

use super::{Builder, Origin};
use crate::description::Given;
use crate::description::{self, Description, inline};
use crate::error::{Errors, Place};
use crate::formulation::{Products, Sines};
use crate::module::Module;
use crate::print::ascii::{beyond, spelt};
use crate::print::c;
use crate::print::rust::{self, CoreFunctions, Item, Library};
use crate::processor::Processor;
use crate::real::{Real, Trigonometry};
use crate::request::Request;
use crate::wording::visible;

/// The error of an option that only C has.
pub(super) fn only_for_c(request: &Request) -> Option<String> {
    let key = request.for_c.first()?;
    Some(format!("`{key}` is for C only"))
}

impl Builder {
    /// The struct and its methods.
    ///
    /// # Errors
    /// All errors of the description and of the request.
    pub fn to_tokens(&self) -> Result<TokenStream, Errors> {
        Ok(self.print(&self.module()?))
    }

    pub(super) fn print(&self, module: &Module) -> TokenStream {
        rust::print(module, &self.item(module), &self.library())
    }

    pub(super) fn item(&self, module: &Module) -> Item {
        let named_after = || Item::named_after(&module.about.robot);
        self.name.clone().map_or_else(named_after, Item::made)
    }

    pub(super) fn library(&self) -> Library {
        match &self.request.runtime {
            Some(path) => Library::Runtime(path.clone()),
            None => Library::Core(self.core_functions()),
        }
    }

    /// The functions that code without the runtime calls. `core` has no sines: those of the platform are in the crate
    /// `libm`.
    pub(super) fn core_functions(&self) -> CoreFunctions {
        let mut core_functions = self.core_functions.clone();
        if self.request.formulation.sines == Sines::Platform && core_functions.sin_cos.is_none() {
            core_functions.sin_cos = Some(match self.request.scalar {
                Real::F32 => quote! { ::libm::sincosf },
                Real::F64 | Real::Generic => quote! { ::libm::sincos },
            });
        }
        core_functions
    }

    /// The module of the robot.
    #[doc(hidden)]
    pub fn module(&self) -> Result<Module, Errors> {
        // `core` has no fused operations, so the operation count must not include them.
        self.module_where(self.request.runtime.is_some(), false)
    }

    /// The module, with the parts for a reviewer of a file.
    #[doc(hidden)]
    pub fn file_module(&self) -> Result<Module, Errors> {
        self.module_where(self.request.runtime.is_some(), true)
    }

    /// The description and the request.
    fn both(&self) -> Result<(Description, Request), Errors> {
        let mut errors = self.mistakes.clone();
        let loops = self.request.loops.iter().map(String::as_str);
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
        request.trigonometry = match (&request.runtime, self.core_functions().sin_cos) {
            (Some(_), _) => Trigonometry::Runtime,
            (None, Some(_)) => Trigonometry::Other,
            (None, None) => Trigonometry::Own,
        };
        Ok((description, request))
    }

    /// The module for a target with or without fused operations, with or without the parts for a reviewer.
    pub(super) fn module_where(&self, fuses: bool, review: bool) -> Result<Module, Errors> {
        let (description, mut request) = self.both()?;
        let mut errors = Errors::new();
        request.review = review;
        if !fuses && request.processor != Processor::Portable {
            request.formulation.products = Products::Unfused;
        }
        if request.batch && request.runtime.is_none() {
            let message = "`batch` needs the runtime: code for `core` alone has no batches";
            errors.push(Place::Unknown, message);
            return Err(errors);
        }
        if let Some(message) = only_for_c(&request) {
            errors.push_with_hint(Place::Unknown, message, "leave it out");
            return Err(errors);
        }
        if request.runtime.is_some() && self.core_functions.c_prefix.is_some() {
            let message = "`extern_c` is for files that need only `core`, without the runtime";
            errors.push(Place::Unknown, message);
            return Err(errors);
        }
        let module = (self.expand)(&description, &request)?;
        if self.ascii && review {
            self.check_ascii(&module)?;
        }
        Ok(module)
    }

    /// A text with other letters spelt in ASCII, if that was requested.
    pub(super) fn in_ascii(&self, text: String) -> String {
        if self.ascii { spelt(&text) } else { text }
    }

    /// Rejects names in the file that are not ASCII.
    fn check_ascii(&self, module: &Module) -> Result<(), Errors> {
        let mut errors = Errors::new();
        let name = self.item(module).ident.to_string();
        let names = beyond(module).into_iter();
        for name in names.chain((!name.is_ascii()).then_some(name)) {
            let message = format!("`{}` is a name in the file, and not ASCII", visible(&name));
            let hint = "rename it, or leave out ascii";
            errors.push_with_hint(Place::Unknown, message, hint);
        }
        errors.into_result(())
    }

    /// True if the named processor has fused operations that may be used.
    pub(super) fn fuses(&self, module: &Module) -> bool {
        let processor = self.request.processor;
        !module.reproducible && processor != Processor::Portable && processor.fuses(module.scalar)
    }

    /// The prefix of all names in languages without modules.
    pub(super) fn prefix(&self, module: &Module) -> String {
        let robot = match &self.name {
            Some(name) => name.unraw().to_string(),
            None => module.about.robot.clone(),
        };
        let prefix = self.core_functions.c_prefix.clone();
        prefix.unwrap_or_else(|| c::prefix(&robot))
    }

    fn description(&self, errors: &mut Errors) -> Option<Description> {
        match &self.origin {
            Origin::File(path) => {
                let given = Given::of(&self.request, Path::new(""));
                description::read_file_with(path, &given, None, errors)
            }
            Origin::Description(description) => Some((**description).clone()),
        }
    }
}
