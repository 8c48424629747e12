//! Files in C99 of a [`Builder`]: a header and a source.

use std::path::{Path, PathBuf};

use super::Builder;
use super::command::Language;
use super::file::write;
use super::output::only_for_c;
use crate::error::{Errors, Place};
use crate::module::Module;
use crate::print::arrays::Order;
use crate::print::c::{self, COptions, CSource};
use crate::real::Real;
use crate::request::ForC;

impl Builder {
    /// The functions in C99: a source, and a header that it includes by this name.
    ///
    /// Names begin with the prefix of [`Builder::extern_c`], or with [`Builder::name`] or the robot's name in lower
    /// case: `panda_gravity`; those of [`Builder::casadi`] are `panda_casadi_gravity`. Results are written to arrays of
    /// fixed size; fields are those of a struct to which every function takes a pointer.
    /// [`Real::Generic`] becomes `double`. No library function is called, except the sines of
    /// [`Sines::Platform`](crate::formulation::Sines::Platform). Results equal those of the Rust file bit for bit, or,
    /// for a [`Builder::processor`] with fused operations, those of the derive on it.
    ///
    /// # Errors
    /// All errors of the description and of the request; options that only Rust has.
    pub fn to_c(&self, header: &str) -> Result<CSource, Errors> {
        self.c_module().map(|module| self.c(&module, header))
    }

    /// Writes [`Builder::to_c`] to a file in `OUT_DIR`, with its header beside it (`arm.h` beside `arm.c`), and reports
    /// the watched files and the warnings to cargo.
    ///
    /// # Errors
    /// All errors of the description and of the request, each of which cargo shows; files that cannot be written.
    pub fn write_c(&self, file: impl AsRef<Path>) -> Result<(), Errors> {
        let file = file.as_ref();
        self.telling(|| {
            let (header, name) = header_beside(file)?;
            let module = self.c_module()?;
            self.report(&module);
            let source = self.c(&module, &name);
            write(&header, &source.header)?;
            write(file, &source.text)
        })
    }

    /// The module of a file in C.
    #[doc(hidden)]
    pub fn c_module(&self) -> Result<Module, Errors> {
        let mut errors = Errors::new();
        if self.request.runtime.is_some() {
            errors.push(Place::Unknown, "`runtime` is for Rust: C has no runtime");
        }
        if self.core_functions.sin_cos.is_some() {
            errors.push_with_hint(
                Place::Unknown,
                "`sin_cos` is for Rust only",
                "leave it out, since the file has its own sines, or choose the formulation platform_sines",
            );
        }
        let for_c = self.request.for_c;
        if let (Some(key), Real::F32) = (for_c.first_of_f64(), self.request.scalar) {
            let message = format!("`{key}` is for numbers of f64: the solver has no others");
            errors.push_with_hint(Place::Unknown, message, "leave out the scalar type f32");
        }
        // Further errors are those without these options.
        let mut without = self.clone();
        without.request.for_c = ForC::default();
        without.request.runtime = None;
        without.core_functions.sin_cos = None;
        let module = without.module_where(true, true);
        if let (Some(rule), Ok(module)) = (for_c.steps, &module)
            && let Err([message, hint]) = c::check_steps(module, rule, for_c.acados)
        {
            errors.push_with_hint(Place::Unknown, message, hint);
        }
        if for_c.acados && for_c.steps.is_none() {
            let hint = "add a rule by steps";
            errors.push_with_hint(Place::Unknown, "`acados` needs `steps`", hint);
        }
        if let (true, Ok(module)) = (for_c.casadi, &module) {
            let prefix = self.prefix(module);
            if ["jac_", "adj1_"]
                .iter()
                .any(|begin| prefix.starts_with(begin))
            {
                let message = format!(
                    "CasADi takes names with the prefix `{prefix}` for those of derivatives"
                );
                let hint = "choose another prefix with extern_c";
                errors.push_with_hint(Place::Unknown, message, hint);
            }
        }
        errors.joined(module)
    }

    /// The module of another compiled language: that of a file in C.
    #[doc(hidden)]
    pub fn compiled_module(&self) -> Result<Module, Errors> {
        let mut without = self.clone();
        without.request.for_c = ForC::default();
        let mut errors = Errors::new();
        if let Some(message) = only_for_c(&self.request) {
            errors.push_with_hint(Place::Unknown, message, "leave it out");
        }
        errors.joined(without.c_module())
    }

    /// The file in C of a module.
    #[doc(hidden)]
    #[must_use]
    pub fn c(&self, module: &Module, header: &str) -> CSource {
        let CSource { header, text } = self.written(module, header, c::print);
        let [header, text] = [header, text].map(|text| self.in_ascii(text));
        CSource { header, text }
    }

    /// The same with a source for each function, which are compiled side by side: names and texts, the header first, and
    /// then `arm.c` beside `arm.h`, which has everything that is not a function of the request.
    #[doc(hidden)]
    #[must_use]
    pub fn c_files(&self, module: &Module, header: &str) -> Vec<(String, String)> {
        let files = self.written(module, header, c::print_apart).into_iter();
        let files = files.map(|(name, text)| (name, self.in_ascii(text)));
        files.collect()
    }

    fn written<T>(
        &self,
        module: &Module,
        header: &str,
        print: impl FnOnce(&Module, &COptions<'_>) -> T,
    ) -> T {
        let options = COptions {
            prefix: &self.prefix(module),
            header,
            asked: &self.asked(module, Language::C(header)),
            fused: self.fuses(module),
            for_c: self.request.for_c,
            templates: false,
            order: Order::AngularFirst,
        };
        print(module, &options)
    }
}

/// The path of a file's header, and the name in its `#include`.
#[doc(hidden)]
pub fn header_beside(file: &Path) -> Result<(PathBuf, String), Errors> {
    let header = file.with_extension("h");
    let name = header.file_name().and_then(|name| name.to_str());
    // These characters are implementation-defined between quotes.
    let strange = |letter: char| matches!(letter, '"' | '\\' | '?') || letter.is_control();
    let mut errors = Errors::new();
    match name {
        _ if header == file => {
            let message = format!("{} would overwrite its own header", file.display());
            let hint = "give the source another extension, such as arm.c";
            errors.push_with_hint(Place::Unknown, message, hint);
        }
        Some(name) if !name.contains(strange) => return Ok((header.clone(), name.to_owned())),
        _ => {
            let message = format!("{} cannot be a file name in #include", header.display());
            errors.push(Place::Unknown, message);
        }
    }
    Err(errors)
}
