//! Python packages of a [`Builder`].
//!
//! A package is written to a folder completely or not at all. Files of others are not overwritten.

use std::path::{Path, PathBuf};
use std::{env, fs, io, process};

use super::Builder;
use crate::error::{Errors, Place};
use crate::module::Module;
use crate::print::python::{self, MARK, Package, PackageOptions};
use crate::processor::Processor;

impl Builder {
    /// A package for Python with the module `module`: the functions are methods of a class, for one state or for
    /// `NumPy` arrays of states.
    ///
    /// It consists of Rust around the same functions, is built by `pip` with maturin, and does not depend on this
    /// project. Fields are arguments of the class. [`Real::Generic`](crate::Real::Generic) becomes `float64`.
    ///
    /// # Errors
    /// All errors of the description and of the request; options that a package does not support.
    pub fn to_python(&self, module: &str) -> Result<Package, Errors> {
        let module = in_python(module)?;
        let generated = self.python_module()?;
        Ok(self.python(&generated, &module))
    }

    /// Writes [`Builder::to_python`] to a folder in `OUT_DIR`, with the folder's name as the name of the module, and
    /// reports the watched files and the warnings to cargo.
    ///
    /// # Errors
    /// All errors of the description and of the request, each of which cargo shows; a folder that cannot be written, or
    /// contains other files.
    pub fn write_python(&self, folder: impl AsRef<Path>) -> Result<(), Errors> {
        let folder = folder.as_ref();
        self.telling(|| {
            let within = env::var_os("OUT_DIR")
                .ok_or_else(|| refused("OUT_DIR is not set: call this in a build script"))?;
            let module = module_of(folder)?;
            let generated = self.python_module()?;
            self.report(&generated);
            let package = self.python(&generated, &module);
            write_folder(&Path::new(&within).join(folder), &package)
        })
    }

    /// The module of a package for Python.
    #[doc(hidden)]
    pub fn python_module(&self) -> Result<Module, Errors> {
        let mut errors = Errors::new();
        let mut refuse = |refused: bool, message, hint| {
            if refused {
                errors.push_with_hint(Place::Unknown, message, hint);
            }
        };
        refuse(
            self.request.runtime.is_some() || self.request.batch,
            "`runtime` is for Rust: a package for Python has its own batches",
            "leave it out, since every function takes arrays of states",
        );
        refuse(
            self.core_functions.sin_cos.is_some(),
            "`sin_cos` is for Rust only",
            "leave it out, since the package has its own sines, or choose the formulation platform_sines",
        );
        refuse(
            self.core_functions.c_prefix.is_some(),
            "`extern_c` is for files that need only `core`",
            "leave it out, or write a file in Rust",
        );
        refuse(
            self.request.processor != Processor::Portable,
            "a package for Python selects the processor at run time",
            "leave `processor` out",
        );
        // Further errors are those without these options.
        let mut without = self.clone();
        without.request.runtime = None;
        without.request.batch = false;
        without.request.processor = Processor::Portable;
        without.core_functions = super::CoreFunctions::default();
        errors.joined(without.module_where(false, false))
    }

    /// The package for Python of a module.
    #[doc(hidden)]
    #[must_use]
    pub fn python(&self, generated: &Module, module: &str) -> Package {
        let options = PackageOptions {
            module,
            asked: &self.options(),
        };
        python::print(generated, &self.item(generated), &options)
    }
}

/// The name of a module made from a text.
#[doc(hidden)]
pub fn in_python(text: &str) -> Result<String, Errors> {
    python::module(text).ok_or_else(|| {
        let mut errors = Errors::new();
        errors.push_with_hint(
            Place::Unknown,
            "a module of this name would hide NumPy",
            "choose another name",
        );
        errors
    })
}

/// The name of the module in a folder.
#[doc(hidden)]
pub fn module_of(folder: &Path) -> Result<String, Errors> {
    let name = folder.file_name().and_then(|name| name.to_str());
    let name =
        name.ok_or_else(|| refused("the module has the name of the folder: name a folder"))?;
    in_python(name)
}

/// Writes a package to a new folder beside `folder`, and then moves it there.
#[doc(hidden)]
pub fn write_folder(folder: &Path, package: &Package) -> Result<(), Errors> {
    let fail = |reason: io::Error| refused(format!("cannot write {}: {reason}", folder.display()));
    let exists = match fs::symlink_metadata(folder) {
        Ok(_) => true,
        Err(reason) if reason.kind() == io::ErrorKind::NotFound => false,
        Err(reason) => return Err(fail(reason)),
    };
    if exists {
        check_own(folder)?;
    }
    let fresh = beside(folder, "new");
    let written = write_all(&fresh, package).and_then(|()| {
        if !exists {
            return fs::rename(&fresh, folder);
        }
        // Build outputs are kept, so that nothing is built again.
        for kept in KEPT {
            if folder.join(kept).exists() {
                fs::rename(folder.join(kept), fresh.join(kept))?;
            }
        }
        let old = beside(folder, "old");
        fs::rename(folder, &old)?;
        if let Err(reason) = fs::rename(&fresh, folder) {
            fs::rename(&old, folder)?;
            return Err(reason);
        }
        fs::remove_dir_all(&old)
    });
    written.map_err(|reason| {
        // The rest is useless, and the first error is the one to report.
        let _ = fs::remove_dir_all(&fresh);
        fail(reason)
    })
}

/// The entries of a package's folder.
const OWN: [&str; 5] = ["Cargo.toml", "pyproject.toml", "README.md", "src", "python"];

/// Entries that `pip` and `cargo` add.
const KEPT: [&str; 3] = ["target", "Cargo.lock", "build"];

fn write_all(fresh: &Path, package: &Package) -> io::Result<()> {
    for (path, text) in &package.files {
        let path = fresh.join(path);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::write(path, text)?;
    }
    Ok(())
}

/// A folder with a similar name in the same place.
fn beside(folder: &Path, what: &str) -> PathBuf {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    folder.with_file_name(format!(".{name}.{what}.{}", process::id()))
}

/// Rejects a folder with entries that no package has.
fn check_own(folder: &Path) -> Result<(), Errors> {
    let refuse = |what: String| {
        let mut errors = Errors::new();
        errors.push_with_hint(
            Place::Unknown,
            format!("{} is not overwritten: {what}", folder.display()),
            "name a new folder",
        );
        Err(errors)
    };
    let is_marked = |text: String| {
        let first = text.lines().next();
        first.is_some_and(|line| line.starts_with(&format!("# {MARK}")))
    };
    let manifest = fs::read_to_string(folder.join("Cargo.toml"));
    if !manifest.is_ok_and(is_marked) {
        return refuse("it is not a package written by homogen".to_owned());
    }
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !OWN.contains(&&*name) && !KEPT.contains(&&*name) {
            return refuse(format!("{name} in it was not written by homogen"));
        }
    }
    Ok(())
}

fn refused(message: impl Into<String>) -> Errors {
    let mut errors = Errors::new();
    errors.push(Place::Unknown, message);
    errors
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{MARK, Package, write_folder};

    fn package(text: &str) -> Package {
        let files = [
            ("Cargo.toml", format!("# {MARK}")),
            ("src/lib.rs", text.to_owned()),
        ];
        Package {
            module: "arm".to_owned(),
            class: "Arm".to_owned(),
            files: files.map(|(path, text)| (path.to_owned(), text)).to_vec(),
        }
    }

    #[test]
    fn a_folder_is_whole_or_left_alone() {
        let base = std::env::temp_dir().join(format!("homogen-python-{}", std::process::id()));
        fs::create_dir_all(&base).expect("a folder");
        let folder = base.join("arm");
        write_folder(&folder, &package("first")).expect("a new folder");
        fs::create_dir(folder.join("target")).expect("something that was built");
        write_folder(&folder, &package("second")).expect("the same folder again");
        assert_eq!(
            fs::read_to_string(folder.join("src/lib.rs")).expect("a file"),
            "second"
        );
        assert!(folder.join("target").exists());

        fs::write(folder.join("notes"), "mine").expect("a foreign file");
        let errors = write_folder(&folder, &package("third")).expect_err("not overwritten");
        assert!(errors.to_string().contains("notes in it"), "{errors}");
        // A failed write leaves nothing behind.
        let mut wrong = package("fourth");
        wrong.files.push(("src".to_owned(), String::new()));
        assert!(write_folder(&base.join("other"), &wrong).is_err());
        let mut left: Vec<_> = fs::read_dir(&base)
            .expect("the folder")
            .map(|entry| entry.expect("an entry").file_name())
            .collect();
        left.sort();
        assert_eq!(left, ["arm"]);
        assert_eq!(
            fs::read_to_string(folder.join("src/lib.rs")).expect("a file"),
            "second"
        );
        fs::remove_dir_all(&base).expect("the folder is removed");
    }
}
