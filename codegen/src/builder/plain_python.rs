//! Plain Python of a [`Builder`], as text.

use quote::quote;

use super::Builder;
use super::command::Language;
use super::output::only_for_c;
use crate::error::{Errors, Place};
use crate::module::Module;
use crate::print::arrays::Order;
use crate::print::plain_python::{self, PythonOptions};
use crate::processor::Processor;
use crate::request::ForC;

impl Builder {
    /// The functions as a module of Python that needs `math` alone, over numbers of any type: floats, arrays of `NumPy`,
    /// symbols of `CasADi` and `SymPy`, tensors. `order` is that of twists, wrenches and momenta.
    ///
    /// Arguments are vectors, results numbers and lists of rows; fields are keywords. Operations and their order are those
    /// of the file in C, so that results have its bits where sines have.
    ///
    /// # Errors
    /// All errors of the description and of the request; options that only other languages have.
    pub fn to_plain_python(&self, order: Order) -> Result<String, Errors> {
        let module = self.plain_python_module()?;
        Ok(self.plain_python(&module, order))
    }

    /// The module of a file in Python.
    #[doc(hidden)]
    pub fn plain_python_module(&self) -> Result<Module, Errors> {
        let mut errors = Errors::new();
        if let Some(message) = only_for_c(&self.request) {
            errors.push_with_hint(Place::Unknown, message, "leave it out");
        }
        for (is_set, option) in [
            (self.request.runtime.is_some(), "`runtime` is"),
            (self.core_functions.sin_cos.is_some(), "`sin_cos` is"),
            (self.core_functions.c_prefix.is_some(), "`extern_c` is"),
            (self.name.is_some(), "`name` is"),
            (self.ascii, "`ascii` is"),
            (self.request.prepare, "`prepare` is"),
            (self.request.section.is_some(), "`section` is"),
            (
                self.request.processor != Processor::Portable,
                "`processor` is",
            ),
        ] {
            if is_set {
                let message = format!("{option} for compiled languages, and not for Python");
                errors.push_with_hint(Place::Unknown, message, "leave it out");
            }
        }
        // Further errors are those without these options. Sines are those of a library.
        let mut without = self.clone();
        without.name = None;
        without.ascii = false;
        without.request.runtime = None;
        without.request.prepare = false;
        without.request.for_c = ForC::default();
        without.request.section = None;
        without.request.processor = Processor::Portable;
        without.core_functions.c_prefix = None;
        without.core_functions.sin_cos = Some(quote! { library });
        errors.joined(without.module_where(false, true))
    }

    /// The file in Python of a module.
    #[doc(hidden)]
    #[must_use]
    pub fn plain_python(&self, module: &Module, order: Order) -> String {
        let asked = self.asked(module, Language::Python(order));
        let asked = &asked;
        plain_python::print(module, &PythonOptions { asked, order })
    }
}
