//! States of a robot, as many at a time as wanted.
//!
//! In: files in JSON or of NumPy, and the arguments of a function. Out: the numbers it needs. JSON is read at once, and
//! refused where a number is not finite; files of NumPy are read piece by piece, and NaN there is a number to IEEE's
//! arithmetic.

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

    /// Whether a state has numbers alone.
    pub(super) fn are_finite(&self, state: usize) -> bool {
        let mut arguments = (0..self.numbers.len()).flat_map(|k| self.argument(k, state));
        arguments.all(|number| number.is_finite())
    }
}

/// A file that was named on the command line, with the argument or the result that it holds where that was said.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub(super) name: Option<String>,
    pub(super) path: PathBuf,
}

impl Named {
    /// Reads `FILE` or `NAME=FILE`, where that is one of the names that there can be.
    pub(super) fn of(text: &OsStr, names: impl IntoIterator<Item = &'static str>) -> Self {
        let said = text.to_str().and_then(|text| text.split_once('='));
        let said = said.filter(|(name, _)| names.into_iter().any(|other| other == *name));
        match said {
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

/// What kind of file a path is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Json,
    Npy,
}

impl Kind {
    /// The kind that a path ends in, if it is one of them.
    pub(super) fn of(path: &Path) -> Option<Self> {
        Some(match path.extension()?.to_str()? {
            "json" => Self::Json,
            "npy" => Self::Npy,
            _ => return None,
        })
    }
}

/// Where states come from.
pub(super) enum Source {
    /// All that there are, and how many of them have been handed on.
    Listed(Vec<listed::State>, usize),
    /// A file for each argument, with as many states each.
    Arrays(Vec<npy::Reader>),
}

impl Source {
    /// Opens files of states for a function of these arguments.
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
                        "an .npy file holds one argument, and the function has {}",
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
                    "there are {} states of {argument}, and {count} of {first}",
                    other.count
                );
                errors.push(Place::Unknown, message);
            }
        }
        let readers = readers.into_iter().map(|(_, reader)| reader);
        errors.into_result(Self::Arrays(readers.collect()))
    }

    /// How many states there are.
    pub(super) fn count(&self) -> usize {
        match self {
            Self::Listed(states, _) => states.len(),
            Self::Arrays(readers) => readers.first().map_or(0, |reader| reader.count),
        }
    }

    /// The next states, of which there must be that many.
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
            let hint = "beside others, each file is of an argument: --states q=q.npy";
            errors.push_with_hint(
                Place::Unknown,
                format!("nothing says what {path} holds"),
                hint,
            );
            continue;
        };
        if files[..k]
            .iter()
            .any(|other| other.name.as_ref() == Some(name))
        {
            errors.push(Place::Unknown, format!("{name} is given twice"));
        } else if !arguments.iter().any(|argument| argument.name() == name) {
            errors.push(
                Place::Unknown,
                format!("the function is none of {name}: {path} is not needed"),
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
            let message = format!("there is no {name} among the states");
            errors.push_with_hint(Place::Unknown, message, hint);
        }
    }
    errors.into_result(found)
}

/// The text of a file of JSON and what messages call it.
fn text(path: &Path, input: &mut dyn Read) -> Result<(String, String), Errors> {
    let (bytes, name) = if is_standard_input(path) {
        (read(input)?, STANDARD_INPUT.to_owned())
    } else {
        let name = path.file_name().map_or(path, Path::new);
        let bytes = std::fs::read(path).map_err(|reason| unreadable(path, &reason))?;
        (bytes, name.display().to_string())
    };
    // Programs of Windows put a mark before the text.
    let unmarked = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    match std::str::from_utf8(unmarked) {
        Ok(text) if !is_utf_16(unmarked) => Ok((text.to_owned(), name)),
        _ => {
            let encoding = if is_utf_16(unmarked) {
                "is written in UTF-16"
            } else {
                "is not written in UTF-8"
            };
            let mut errors = Errors::new();
            let message = format!("{name} {encoding}");
            errors.push_with_hint(Place::Unknown, message, "save it as UTF-8");
            Err(errors)
        }
    }
}
