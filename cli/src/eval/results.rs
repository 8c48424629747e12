//! Writes results to files or prepares them for standard output.
//!
//! Files of NumPy are written state by state; they get their names together, once all of them are complete.

use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::super::fresh::Fresh;
use super::super::options::mistake;
use super::answer::{Layout, Shaped};
use super::npy;
use super::states::{Kind, Named};
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::function::Function;

/// Destination of results.
pub(super) enum Wanted {
    /// Standard output.
    Shown,
    /// A JSON file, written at once.
    Text(PathBuf),
    /// An .npy file for each result.
    Arrays(Vec<PathBuf>),
}

impl Wanted {
    /// The destination of the results of a function, for the files of the command line.
    pub(super) fn of(files: &[OsString], function: Function) -> Result<Self, Errors> {
        let names: Vec<&'static str> = function
            .result()
            .parts()
            .filter_map(|(name, _)| name)
            .collect();
        let files = files
            .iter()
            .map(|file| Named::of(file, names.iter().copied()));
        let files: Vec<Named> = files.collect();
        match &*files {
            [] => Ok(Self::Shown),
            [Named { name: None, path }] => match Kind::of(path) {
                Some(Kind::Json) => Ok(Self::Text(path.clone())),
                Some(Kind::Npy) if names.is_empty() => Ok(Self::Arrays(vec![path.clone()])),
                Some(Kind::Npy) => Err(several(&names)),
                None => Err(mistake(format!(
                    "the format of {} is unknown: name it .npy or .json",
                    path.display()
                ))),
            },
            _ => each(&files, &names).map(Self::Arrays),
        }
    }
}

/// A file for each result, in the order of the results.
fn each(files: &[Named], names: &[&str]) -> Result<Vec<PathBuf>, Errors> {
    let of = |wanted: &str| {
        let mut all = files
            .iter()
            .filter(move |file| file.name.as_deref() == Some(wanted));
        (all.next(), all.next())
    };
    let paths = names.iter().map(|name| match of(name) {
        (Some(file), None) => Some(file.path.clone()),
        _ => None,
    });
    let paths: Option<Vec<PathBuf>> = paths.collect();
    let paths = paths.filter(|paths| !paths.is_empty() && paths.len() == files.len());
    paths.ok_or_else(|| several(names))
}

fn several(names: &[&str]) -> Errors {
    let mut errors = Errors::new();
    let message = "write each result to an .npy file of its own";
    let names = names.iter();
    let each: Vec<String> = names.map(|name| format!("--output {name}=FILE")).collect();
    let hint = match &*each {
        [] => "--output FILE".to_owned(),
        each => each.join(" "),
    };
    errors.push_with_hint(Place::Unknown, message, hint);
    errors
}

/// The open files of NumPy, one for each result.
pub(super) struct Sink(Vec<npy::Writer>);

impl Sink {
    /// Begins the files, for `states` states.
    pub(super) fn begin(
        paths: &[PathBuf],
        layout: &Layout<'_>,
        count: usize,
    ) -> Result<Self, Errors> {
        let files = paths.iter().zip(&layout.results);
        let files = files.map(|(path, Shaped { lengths, .. })| {
            npy::Writer::create(path, layout.scalar, count, lengths)
        });
        files.collect::<Result<_, _>>().map(Self)
    }

    /// Writes the numbers of the next states.
    pub(super) fn write(
        &mut self,
        layout: &Layout<'_>,
        numbers: &[f64],
        states: usize,
    ) -> Result<(), Errors> {
        let mut files = self.0.iter_mut().zip(layout.columns(numbers, states));
        files.try_for_each(|(file, column)| file.write(&column))
    }

    /// Gives the files their names.
    pub(super) fn finish(self) -> Result<(), Errors> {
        let files = self.0.into_iter().map(npy::Writer::complete);
        let files: Vec<Fresh> = files.collect::<Result<_, _>>()?;
        files.into_iter().try_for_each(Fresh::keep)
    }
}

/// Writes a text to a file.
pub(super) fn write(path: &Path, text: &str) -> Result<(), Errors> {
    let mut file = Fresh::create(path)?;
    let written = file.write_all(text.as_bytes());
    written.map_err(|reason| file.refused(&reason))?;
    file.complete()?.keep()
}
