//! The package for Python that a [`Builder`] writes.
//!
//! In: its options, and a folder. Out: the files of the package in that folder, all of them or none. It never
//! writes over what it has not written.

use std::path::{Path, PathBuf};
use std::{env, fs, io, process};

use super::Builder;
use crate::error::{Errors, Place};
use crate::module::Module;
use crate::print::python::{self, MARK, Package, Writing};
use crate::processor::Processor;

impl Builder {
    /// A package for Python, which `import`s as `module`: the functions as methods of a class, of one state or of
    /// `NumPy` arrays of states.
    ///
    /// It is Rust around the same functions, built by `pip` with maturin, and needs nothing of this project.
    /// Fields are arguments of the class. [`Real::Generic`](crate::Real::Generic) is taken for `float64`.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request; options that a package has no use for.
    pub fn to_python(&self, module: &str) -> Result<Package, Errors> {
        let module = in_python(module)?;
        let listing = self.python_module()?;
        Ok(self.python(&listing, &module))
    }

    /// Writes [`Builder::to_python`] to a folder in `OUT_DIR`, after whose name the module is called, and tells
    /// cargo which file to watch and what is doubtful about it.
    ///
    /// # Errors
    /// All the mistakes of the description and of the request, each of which cargo shows; a folder that cannot
    /// be written, or holds what was not written by this.
    pub fn write_python(&self, folder: impl AsRef<Path>) -> Result<(), Errors> {
        let folder = folder.as_ref();
        self.telling(|| {
            let within = env::var_os("OUT_DIR")
                .ok_or_else(|| refused("OUT_DIR is not set: this is for build scripts"))?;
            let module = module_of(folder)?;
            let listing = self.python_module()?;
            self.report(&listing);
            let package = self.python(&listing, &module);
            write_folder(&Path::new(&within).join(folder), &package)
        })
    }

    /// What a package for Python is made of.
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
            "the runtime is Rust's: a package for Python has its own batches",
            "leave it out: every function takes arrays of states",
        );
        refuse(
            self.library.sin_cos.is_some(),
            "a function for sines and cosines can be named in Rust only",
            "leave it out: the package brings its own; or choose the formulation platform_sines",
        );
        refuse(
            self.library.c_prefix.is_some(),
            "functions for C are of files that need `core` alone",
            "leave them out, or write such a file",
        );
        refuse(
            self.request.processor != Processor::Portable,
            "a package for Python finds its processor when it runs",
            "leave the processor out",
        );
        // The other mistakes are those that it has without these options.
        let mut without = self.clone();
        without.request.runtime = None;
        without.request.batch = false;
        without.request.processor = Processor::Portable;
        without.library = super::Library::default();
        match without.module_where(false, false) {
            Ok(listing) => errors.into_result(listing),
            Err(mistakes) => {
                errors.append(mistakes);
                Err(errors)
            }
        }
    }

    /// The package for Python of a module.
    #[doc(hidden)]
    #[must_use]
    pub fn python(&self, listing: &Module, module: &str) -> Package {
        let writing = Writing {
            module,
            options: &self.options(),
        };
        python::print(listing, &self.item(listing), &writing)
    }
}

/// What a module is called after a text.
#[doc(hidden)]
pub fn in_python(text: &str) -> Result<String, Errors> {
    python::module(text).ok_or_else(|| {
        let mut errors = Errors::new();
        errors.push_with_hint(
            Place::Unknown,
            "a module of that name would hide NumPy",
            "choose another name",
        );
        errors
    })
}

/// What a module is called that is written to a folder.
#[doc(hidden)]
pub fn module_of(folder: &Path) -> Result<String, Errors> {
    let name = folder.file_name().and_then(|name| name.to_str());
    let name =
        name.ok_or_else(|| refused("the module is called after the folder: it needs a name"))?;
    in_python(name)
}

/// Writes a package to a fresh folder beside `folder`, and then puts it in its place.
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
        // What has been built of it is not to be built again.
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
        // What is left of it is of no use, and the first reason is the one to tell.
        let _ = fs::remove_dir_all(&fresh);
        fail(reason)
    })
}

/// What the folder of a package has in it.
const OWN: [&str; 5] = ["Cargo.toml", "pyproject.toml", "README.md", "src", "python"];

/// What `pip` and `cargo` leave there.
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

/// A folder of a similar name in the same place.
fn beside(folder: &Path, what: &str) -> PathBuf {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    folder.with_file_name(format!(".{name}.{what}.{}", process::id()))
}

/// Refuses a folder with anything in it that no package has.
fn check_own(folder: &Path) -> Result<(), Errors> {
    let refuse = |what: String| {
        let mut errors = Errors::new();
        errors.push_with_hint(
            Place::Unknown,
            format!("{} is not overwritten: {what}", folder.display()),
            "name a folder that is not there yet",
        );
        Err(errors)
    };
    let is_marked = |text: String| {
        let first = text.lines().next();
        first.is_some_and(|line| line.starts_with(&format!("# {MARK}")))
    };
    let manifest = fs::read_to_string(folder.join("Cargo.toml"));
    if !manifest.is_ok_and(is_marked) {
        return refuse("it is no package that homogen has written".to_owned());
    }
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !OWN.contains(&&*name) && !KEPT.contains(&&*name) {
            return refuse(format!("{name} in it was written by somebody else"));
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
        let room = std::env::temp_dir().join(format!("homogen-python-{}", std::process::id()));
        fs::create_dir_all(&room).expect("a room");
        let folder = room.join("arm");
        write_folder(&folder, &package("first")).expect("a new folder");
        fs::create_dir(folder.join("target")).expect("something that was built");
        write_folder(&folder, &package("second")).expect("the same folder again");
        assert_eq!(
            fs::read_to_string(folder.join("src/lib.rs")).expect("a file"),
            "second"
        );
        assert!(folder.join("target").exists());

        fs::write(folder.join("notes"), "mine").expect("a file of somebody's");
        let errors = write_folder(&folder, &package("third")).expect_err("not overwritten");
        assert!(errors.to_string().contains("notes in it"), "{errors}");
        // What cannot be written leaves nothing behind.
        let mut wrong = package("fourth");
        wrong.files.push(("src".to_owned(), String::new()));
        assert!(write_folder(&room.join("other"), &wrong).is_err());
        let mut left: Vec<_> = fs::read_dir(&room)
            .expect("the room")
            .map(|entry| entry.expect("an entry").file_name())
            .collect();
        left.sort();
        assert_eq!(left, ["arm"]);
        assert_eq!(
            fs::read_to_string(folder.join("src/lib.rs")).expect("a file"),
            "second"
        );
        fs::remove_dir_all(&room).expect("the room is emptied");
    }
}
