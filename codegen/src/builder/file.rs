//! Files in Rust of a [`Builder`]: formatted text with a head of origin, options and operation counts, in `OUT_DIR`;
//! and reports to cargo.

use std::path::Path;
use std::{env, fs};

use super::command::Language;
use super::{Builder, Origin};
use crate::description::Name;
use crate::error::{Errors, Place};
use crate::module::Module;
use crate::print::rust::{self, FormattedSource};
use crate::processor::Processor;
use crate::real::Real;

impl Builder {
    /// [`Builder::to_tokens`] as formatted text, with a head of origin, options and operation counts.
    ///
    /// # Errors
    /// All errors of the description and of the request.
    pub fn to_source(&self) -> Result<FormattedSource, Errors> {
        self.file_module().map(|module| self.source(&module))
    }

    /// Writes [`Builder::to_source`] to a file in `OUT_DIR`, and reports the watched files and the warnings to cargo.
    ///
    /// # Errors
    /// All errors of the description and of the request, each of which cargo shows; a file that cannot be written.
    pub fn write(&self, file: impl AsRef<Path>) -> Result<(), Errors> {
        self.telling(|| {
            let module = self.file_module()?;
            self.report(&module);
            write(file.as_ref(), &self.source(&module).to_string())
        })
    }

    /// Reports further watched files and, unless `quiet` is set, the warnings to cargo.
    pub(super) fn report(&self, module: &Module) {
        for path in &module.about.source.beside {
            println!("cargo::rerun-if-changed={}", path.display());
        }
        if self.request.quiet {
            return;
        }
        for warning in module.about.located_warnings() {
            println!("cargo::warning={warning}");
        }
    }

    /// Calls `write`, and reports the watched file and each error to cargo.
    pub(super) fn telling(
        &self,
        writes: impl FnOnce() -> Result<(), Errors>,
    ) -> Result<(), Errors> {
        if let Origin::File(path) = &self.origin {
            println!("cargo::rerun-if-changed={}", path.display());
        }
        let written = writes();
        if let Err(errors) = &written {
            for line in errors.to_string().lines() {
                println!("cargo::error={}", line.trim_start_matches("error: "));
            }
        }
        written
    }

    /// The header of the functions that [`Builder::extern_c`] adds: arrays of fixed size, with units and frames in
    /// comments; empty without `extern_c`.
    ///
    /// # Errors
    /// All errors of the description and of the request.
    pub fn to_c_header(&self) -> Result<String, Errors> {
        self.file_module().map(|module| self.c_header(&module))
    }

    /// Writes [`Builder::to_c_header`] to a file in `OUT_DIR`.
    ///
    /// # Errors
    /// All errors of the description and of the request; a file that cannot be written.
    pub fn write_c_header(&self, file: impl AsRef<Path>) -> Result<(), Errors> {
        write(file.as_ref(), &self.to_c_header()?)
    }

    /// The header of the C functions of a file in Rust.
    #[doc(hidden)]
    #[must_use]
    pub fn c_header(&self, module: &Module) -> String {
        let item = self.item(module);
        let asked = self.asked(module, Language::Rust);
        let header =
            rust::c_header(module, &item, &asked, &self.core_functions()).unwrap_or_default();
        self.in_ascii(header)
    }

    /// The file in Rust of a module.
    #[doc(hidden)]
    #[must_use]
    pub fn source(&self, module: &Module) -> FormattedSource {
        let header = rust::header(module, &self.asked(module, Language::Rust), &self.library());
        let appendix = rust::appendix(module, &self.item(module), &self.library());
        let source = FormattedSource::file(header, &self.print(module), appendix);
        if self.ascii {
            source.in_ascii()
        } else {
            source
        }
    }

    /// The options in words, for the head of the file.
    pub(super) fn options(&self) -> String {
        let request = &self.request;
        let number = match (request.scalar, &request.runtime) {
            (Real::F32, _) => "f32",
            (Real::Generic, Some(_)) => "any scalar",
            (Real::F64 | Real::Generic, _) => "f64",
        };
        let named = |word: &'static str| move |name: &Name| format!("{word} {}", name.text);
        let mut options = vec![number.to_owned()];
        options.extend(request.base.iter().map(named("base")));
        options.extend(request.tip.iter().map(named("tip")));
        options.extend(request.path_only.then(|| "path only".to_owned()));
        options.extend(request.lock.iter().map(|(joint, at)| {
            let at = at.map_or(0.0, |at| at.value);
            format!("lock {}={at:?}", joint.text)
        }));
        options.extend(request.drop.iter().map(named("drop")));
        options.extend(request.frames.iter().map(named("frame")));
        let fields = request.parameters.iter();
        options.extend(fields.map(|parameter| format!("field {}", parameter.field)));
        options.extend(request.gravity.map(|gravity| {
            let gravity = gravity.map(|number| number.value);
            format!("gravity {gravity:?}")
        }));
        options.extend(request.exact.then(|| "exact".to_owned()));
        options.extend(request.strict.then(|| "strict".to_owned()));
        options.extend(request.reproducible.then(|| "reproducible".to_owned()));
        options.extend(request.batch.then(|| "batch".to_owned()));
        options.extend(request.prepare.then(|| "prepare".to_owned()));
        options.extend(request.section.map(|most| format!("section {most}")));
        let chosen = request.processor != Processor::Portable;
        options.extend(chosen.then(|| format!("processor {}", request.processor.name())));
        let prefix = self.core_functions.c_prefix.as_ref();
        options.extend(prefix.map(|prefix| format!("functions {prefix}… for C")));
        options.join(", ")
    }
}

pub(super) fn write(file: &Path, text: &str) -> Result<(), Errors> {
    let refuse = |message: String| {
        let mut errors = Errors::new();
        errors.push(Place::Unknown, message);
        errors
    };
    let folder = env::var_os("OUT_DIR")
        .ok_or_else(|| refuse("OUT_DIR is not set: call this in a build script".to_owned()))?;
    let path = Path::new(&folder).join(file);
    fs::write(&path, text)
        .map_err(|reason| refuse(format!("cannot write {}: {reason}", path.display())))
}
