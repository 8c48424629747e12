//! The files in C that a [`Builder`] writes.
//!
//! In: its options. Out: a header and a source in C99, in `OUT_DIR`. It never writes anywhere else.

use std::path::{Path, PathBuf};

use super::Builder;
use super::command::Language;
use super::file::write;
use crate::error::{Errors, Place};
use crate::module::Module;
use crate::print::ascii::spelt;
use crate::print::c::{self, Source, Writing};

impl Builder {
    /// The same functions in C99: a source, and a header that it includes by this name.
    ///
    /// Names begin with what [`Builder::extern_c`] says, or with [`Builder::name`] or the robot's name in
    /// small letters: `panda_gravity`. Results are written to arrays of fixed size; fields are those of a
    /// struct that every function takes a pointer to. [`Real::Generic`](crate::Real::Generic) is taken for
    /// `double`. No function of the library is called, but sines with
    /// [`Sines::Platform`](crate::formulation::Sines::Platform). The bits are those of the file in Rust;
    /// for a [`Builder::processor`] that fuses products with sums, those of the derive on it.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request; options that only Rust has.
    pub fn to_c(&self, header: &str) -> Result<Source, Errors> {
        self.c_module().map(|module| self.c(&module, header))
    }

    /// Writes [`Builder::to_c`] to a file in `OUT_DIR`, its header beside it (`arm.h` beside `arm.c`), and
    /// tells cargo which file to watch and what is doubtful about it.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request, each of which cargo shows; files that
    /// cannot be written.
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

    /// What a file in C is made of.
    #[doc(hidden)]
    pub fn c_module(&self) -> Result<Module, Errors> {
        let mut errors = Errors::new();
        if self.request.runtime.is_some() {
            errors.push(Place::Unknown, "the runtime is Rust's: C has none");
        }
        if self.library.sin_cos.is_some() {
            errors.push_with_hint(
                Place::Unknown,
                "a function for sines and cosines can be named in Rust only",
                "leave it out: the file brings its own; or choose the formulation platform_sines",
            );
        }
        // The other mistakes are those that it has without these options.
        let mut without = self.clone();
        without.request.runtime = None;
        without.library.sin_cos = None;
        match without.module_where(true, true) {
            Ok(module) => errors.into_result(module),
            Err(mistakes) => {
                errors.append(mistakes);
                Err(errors)
            }
        }
    }

    /// The file in C of a module.
    #[doc(hidden)]
    #[must_use]
    pub fn c(&self, module: &Module, header: &str) -> Source {
        let prefix = self.prefix(module);
        let writing = Writing {
            prefix: &prefix,
            header,
            asked: &self.asked(module, Language::C(header)),
            fused: self.fuses(module),
        };
        let Source { header, text } = c::print(module, &writing);
        let [header, text] =
            [header, text].map(|text| if self.ascii { spelt(&text) } else { text });
        Source { header, text }
    }
}

/// The path of the header of a file, and the name by which the file includes it.
#[doc(hidden)]
pub fn header_beside(file: &Path) -> Result<(PathBuf, String), Errors> {
    let header = file.with_extension("h");
    let name = header.file_name().and_then(|name| name.to_str());
    // What a compiler does with these between quotes it decides for itself.
    let strange = |letter: char| matches!(letter, '"' | '\\' | '?') || letter.is_control();
    let mut errors = Errors::new();
    match name {
        _ if header == file => {
            let message = format!("{} is the name of the header", file.display());
            let hint = "give the source another ending, such as arm.c";
            errors.push_with_hint(Place::Unknown, message, hint);
        }
        Some(name) if !name.contains(strange) => return Ok((header.clone(), name.to_owned())),
        _ => {
            let message = format!("no file in C can include {}", header.display());
            errors.push(Place::Unknown, message);
        }
    }
    Err(errors)
}
