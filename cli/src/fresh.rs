//! A file that gets its name only once it is complete.
//!
//! It then replaces another file of that name. An incomplete one leaves nothing behind. Devices and pipes are written
//! to directly.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;

use super::options::mistake;
use homogen_codegen::error::Errors;

/// A file that is being written.
pub(super) struct Fresh {
    file: File,
    /// The path of the command line.
    path: PathBuf,
    /// Its temporary and its final name; `None` if it is written to directly.
    names: Option<(PathBuf, PathBuf)>,
}

impl Fresh {
    /// Begins a file.
    pub(super) fn create(path: &Path) -> Result<Self, Errors> {
        let refuse = |reason: &io::Error| refused(path, reason);
        let own = |file, names| Self {
            file,
            path: path.to_owned(),
            names,
        };
        // For a link, the file that it points to.
        let kept = match fs::canonicalize(path) {
            Ok(there) => there,
            Err(reason) if reason.kind() == ErrorKind::NotFound => path.to_owned(),
            Err(reason) => return Err(refuse(&reason)),
        };
        let about = fs::metadata(&kept).ok();
        if about.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(refuse(&io::Error::other("it is a folder")));
        }
        // A read-only file must not be replaced.
        if about
            .as_ref()
            .is_some_and(|about| about.permissions().readonly())
        {
            return Err(refuse(&ErrorKind::PermissionDenied.into()));
        }
        if about.is_some_and(|about| !about.is_file()) {
            let file = OpenOptions::new().write(true).open(&kept);
            return Ok(own(file.map_err(|reason| refuse(&reason))?, None));
        }
        let mut name = OsString::from(".");
        name.push(kept.file_name().unwrap_or_default());
        name.push(format!(".new.{}", process::id()));
        let passing = kept.with_file_name(name);
        let file = OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(&passing);
        let file = file.map_err(|reason| match reason.kind() {
            ErrorKind::AlreadyExists => refuse(&io::Error::other(format!(
                "{} is in the way",
                passing.display()
            ))),
            _ => refuse(&reason),
        })?;
        Ok(own(file, Some((passing, kept))))
    }

    /// The error of a failed write.
    pub(super) fn refused(&self, reason: &io::Error) -> Errors {
        refused(&self.path, reason)
    }

    /// Completes it on disk, still under its temporary name.
    pub(super) fn complete(self) -> Result<Self, Errors> {
        if self.names.is_some() {
            let stored = self.file.sync_all();
            stored.map_err(|reason| self.refused(&reason))?;
        }
        Ok(self)
    }

    /// Gives it its final name.
    pub(super) fn keep(mut self) -> Result<(), Errors> {
        let Some((passing, kept)) = &self.names else {
            return Ok(());
        };
        fs::rename(passing, kept).map_err(|reason| self.refused(&reason))?;
        self.names = None;
        Ok(())
    }
}

impl Write for Fresh {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for Fresh {
    fn drop(&mut self) {
        if let Some((passing, _)) = &self.names {
            // The rest is useless, and an error was reported.
            let _ = fs::remove_file(passing);
        }
    }
}

fn refused(path: &Path, reason: &io::Error) -> Errors {
    mistake(format!("cannot write {}: {reason}", path.display()))
}
