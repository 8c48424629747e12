//! Headers in C++17 of a [`Builder`].

use std::path::Path;

use super::Builder;
use super::command::Language;
use super::file::write;
use crate::error::{Errors, Place};
use crate::module::Module;
use crate::print::arrays::Order;
use crate::print::c::cpp::{self, Header};

impl Builder {
    /// The functions as a header in C++17, `file`: templates over the scalar, in a namespace of the robot's name or of the
    /// prefix of [`Builder::extern_c`], without sources.
    ///
    /// A function returns `std::array`, or a struct of several; fields are those of a struct that it takes first.
    /// Numbers are `double` or `float`, or of any class with operators and `sin`, `cos` and `sqrt`. Results of built-in
    /// numbers equal those of [`Builder::to_c`] bit for bit; `order` is that of twists, wrenches and momenta, which are
    /// angular first in C.
    ///
    /// # Errors
    /// All errors of the description and of the request; options that only other languages have.
    pub fn to_cpp(&self, file: &str, order: Order) -> Result<String, Errors> {
        self.cpp_module()
            .map(|module| self.cpp(&module, file, order))
    }

    /// Writes [`Builder::to_cpp`] to a file in `OUT_DIR`, and reports the watched files and the warnings to cargo.
    ///
    /// # Errors
    /// All errors of the description and of the request, each of which cargo shows; a file that cannot be written.
    pub fn write_cpp(&self, file: impl AsRef<Path>, order: Order) -> Result<(), Errors> {
        let file = file.as_ref();
        self.telling(|| {
            let module = self.cpp_module()?;
            self.report(&module);
            let name = file.file_name().and_then(|name| name.to_str());
            write(file, &self.cpp(&module, name.unwrap_or("robot.hpp"), order))
        })
    }

    /// The module of a header in C++.
    #[doc(hidden)]
    pub fn cpp_module(&self) -> Result<Module, Errors> {
        let mut errors = Errors::new();
        for (is_set, option) in [
            (self.request.prepare, "`prepare`"),
            (self.request.section.is_some(), "`section`"),
        ] {
            if is_set {
                let message = format!("{option} is not for C++");
                errors.push_with_hint(Place::Unknown, message, "leave it out, or generate C");
            }
        }
        let mut without = self.clone();
        without.request.prepare = false;
        without.request.section = None;
        errors.joined(without.compiled_module())
    }

    /// The header in C++ of a module.
    #[doc(hidden)]
    #[must_use]
    pub fn cpp(&self, module: &Module, file: &str, order: Order) -> String {
        let header = Header {
            prefix: &self.prefix(module),
            asked: &self.asked(module, Language::Cpp(file, order)),
            order,
        };
        self.in_ascii(cpp::header(module, &header))
    }

    /// The namespace of that header.
    #[doc(hidden)]
    #[must_use]
    pub fn cpp_namespace(&self, module: &Module) -> String {
        cpp::namespace(&self.prefix(module))
    }
}
