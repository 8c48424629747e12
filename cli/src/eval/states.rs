//! Reads states from JSON or from files of NumPy.
//!
//! JSON is read at once, and numbers that are not finite are errors. Files of NumPy are read in pieces; NaN in them is
//! computed with as in IEEE arithmetic.

use std::ffi::{OsStr, OsString};
use std::io::Read;
use std::path::{Path, PathBuf};

use super::super::options::{STANDARD_INPUT, is_standard_input, read, unreadable};
use super::listed;
use super::npy;
use homogen_codegen::description::is_utf_16;
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::space::{ACTION, Spaces, Variable};

/// The arguments of a function at some states.
#[derive(Clone, Debug, Default)]
pub(super) struct States {
    pub(super) count: usize,
    /// The numbers of each argument, one state after the other.
    numbers: Vec<Vec<f64>>,
}

impl States {
    pub(super) fn new(count: usize, numbers: Vec<Vec<f64>>) -> Self {
        Self { count, numbers }
    }

    /// The numbers of an argument at a state.
    pub(super) fn argument(&self, argument: usize, state: usize) -> &[f64] {
        let numbers = &self.numbers[argument];
        let each = numbers.len() / self.count;
        &numbers[state * each..][..each]
    }

    /// True if all numbers of a state are finite.
    pub(super) fn are_finite(&self, state: usize) -> bool {
        let mut arguments = (0..self.numbers.len()).flat_map(|k| self.argument(k, state));
        arguments.all(|number| number.is_finite())
    }
}

/// A file of the command line, with the argument or the result that it is for, if named.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub(super) name: Option<String>,
    pub(super) path: PathBuf,
}

impl Named {
    /// Reads `FILE`, or `NAME=FILE` if the name is one of `names`.
    pub(super) fn of(text: &OsStr, names: impl IntoIterator<Item = &'static str>) -> Self {
        let named = text.to_str().and_then(|text| text.split_once('='));
        let named = named.filter(|(name, _)| names.into_iter().any(|other| other == *name));
        match named {
            Some((name, path)) => Self {
                name: Some(name.to_owned()),
                path: path.into(),
            },
            None => Self {
                name: None,
                path: text.into(),
            },
        }
    }
}

/// Format of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Json,
    Npy,
}

impl Kind {
    /// The format by the extension of a path, if it is known.
    pub(super) fn of(path: &Path) -> Option<Self> {
        Some(match path.extension()?.to_str()? {
            "json" => Self::Json,
            "npy" => Self::Npy,
            _ => return None,
        })
    }
}

/// Source of states.
pub(super) enum Source {
    /// All states, and the number of those already returned.
    Listed(Vec<listed::State>, usize),
    /// A file for each argument, with the same number of states.
    Arrays(Vec<npy::Reader>),
}

impl Source {
    /// Opens files of states for a function with these arguments.
    pub(super) fn open(
        files: &[OsString],
        arguments: &[Variable],
        spaces: &Spaces,
        input: &mut dyn Read,
    ) -> Result<Self, Errors> {
        let files = files
            .iter()
            .map(|file| Named::of(file, Variable::ALL.map(Variable::name)));
        let files: Vec<Named> = files.collect();
        match &*files {
            [Named { name: None, path }] => match Kind::of(path) {
                Some(Kind::Npy) if arguments.len() > 1 => {
                    let mut errors = Errors::new();
                    let names: Vec<&str> =
                        arguments.iter().map(|argument| argument.name()).collect();
                    let each: Vec<String> = names
                        .iter()
                        .map(|name| format!("--states {name}=FILE"))
                        .collect();
                    let message = format!(
                        "an .npy file has one argument, and the function has {}",
                        names.join(", ")
                    );
                    errors.push_with_hint(Place::Unknown, message, each.join(" "));
                    Err(errors)
                }
                Some(Kind::Npy) => Self::arrays(&[(arguments[0], path)], spaces),
                _ => {
                    let (text, file) = text(path, input)?;
                    Ok(Self::Listed(
                        listed::read(&text, &file, arguments, spaces)?,
                        0,
                    ))
                }
            },
            _ => Self::arrays(&each(&files, arguments)?, spaces),
        }
    }

    fn arrays(files: &[(Variable, &Path)], spaces: &Spaces) -> Result<Self, Errors> {
        let mut errors = Errors::new();
        let mut readers = Vec::new();
        for &(argument, path) in files {
            let lengths = match argument {
                Variable::Actions => vec![spaces.actions(), ACTION.len()],
                _ => vec![spaces.len(argument.space())],
            };
            match npy::Reader::open(path, &lengths) {
                Ok(reader) => readers.push((argument, reader)),
                Err(reason) => errors.append(reason),
            }
        }
        if let Some(((first, one), others)) = readers.split_first() {
            let count = one.count;
            for (argument, other) in others.iter().filter(|(_, other)| other.count != count) {
                let (first, argument) = (first.name(), argument.name());
                let message = format!(
                    "there are {} states of {argument}, but {count} of {first}",
                    other.count
                );
                errors.push(Place::Unknown, message);
            }
        }
        let readers = readers.into_iter().map(|(_, reader)| reader);
        errors.into_result(Self::Arrays(readers.collect()))
    }

    /// Number of states.
    pub(super) fn count(&self) -> usize {
        match self {
            Self::Listed(states, _) => states.len(),
            Self::Arrays(readers) => readers.first().map_or(0, |reader| reader.count),
        }
    }

    /// The next states, of which there must be `count`.
    pub(super) fn next(&mut self, count: usize) -> Result<States, Errors> {
        let numbers = match self {
            Self::Listed(states, at) => {
                let some = &states[*at..*at + count];
                *at += count;
                let arguments = some.first().map_or(0, Vec::len);
                let argument =
                    |k: usize| some.iter().flat_map(|state| &state[k]).copied().collect();
                Ok((0..arguments).map(argument).collect())
            }
            Self::Arrays(readers) => readers
                .iter_mut()
                .map(|reader| reader.next(count))
                .collect(),
        };
        Ok(States::new(count, numbers?))
    }
}

/// A file for each argument, in the order of the parameters.
fn each<'f>(
    files: &'f [Named],
    arguments: &[Variable],
) -> Result<Vec<(Variable, &'f Path)>, Errors> {
    let mut errors = Errors::new();
    for (k, Named { name, path }) in files.iter().enumerate() {
        let path = path.display();
        let Some(name) = name else {
            let hint = "name the argument of each file: --states q=q.npy";
            errors.push_with_hint(
                Place::Unknown,
                format!("the argument in {path} is unknown"),
                hint,
            );
            continue;
        };
        if files[..k]
            .iter()
            .any(|other| other.name.as_ref() == Some(name))
        {
            errors.push(Place::Unknown, format!("{name} occurs twice"));
        } else if !arguments.iter().any(|argument| argument.name() == name) {
            errors.push(
                Place::Unknown,
                format!("the function has no argument {name}: leave {path} out"),
            );
        }
    }
    let mut found = Vec::new();
    for &argument in arguments {
        let name = argument.name();
        let file = files.iter().find(|file| file.name.as_deref() == Some(name));
        if let Some(file) = file {
            found.push((argument, file.path.as_path()));
        } else {
            let hint = format!("--states {name}=FILE");
            let message = format!("the states of {name} are missing");
            errors.push_with_hint(Place::Unknown, message, hint);
        }
    }
    errors.into_result(found)
}

/// The text of a JSON file, with its name in messages.
fn text(path: &Path, input: &mut dyn Read) -> Result<(String, String), Errors> {
    let (bytes, name) = if is_standard_input(path) {
        (read(input)?, STANDARD_INPUT.to_owned())
    } else {
        let name = path.file_name().map_or(path, Path::new);
        let bytes = std::fs::read(path).map_err(|reason| unreadable(path, &reason))?;
        (bytes, name.display().to_string())
    };
    // Programs for Windows put a byte order mark before the text.
    let unmarked = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    match std::str::from_utf8(unmarked) {
        Ok(text) if !is_utf_16(unmarked) => Ok((text.to_owned(), name)),
        _ => {
            let encoding = if is_utf_16(unmarked) {
                "is UTF-16"
            } else {
                "is not UTF-8"
            };
            let mut errors = Errors::new();
            let message = format!("{name} {encoding}");
            errors.push_with_hint(Place::Unknown, message, "save it as UTF-8");
            Err(errors)
        }
    }
}
