//! Arrays in NumPy's files, read and written state by state.
//!
//! Reads the files that `numpy.save` writes for little-endian `float64` and `float32` in C order, as `f64`s; other
//! files are errors. No file is completely in memory.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, ErrorKind, Read, Write};
use std::path::Path;

use super::super::fresh::Fresh;
use super::super::options::{Scalar, mistake, unreadable};
use homogen_codegen::error::{Errors, Place};

/// The first bytes of every such file.
const MAGIC: &[u8; 6] = b"\x93NUMPY";

/// Maximum length of a head; NumPy's own reader has the same limit.
const LONGEST_HEAD: usize = 10_000;

/// A file of states.
pub(super) struct Reader {
    bytes: BufReader<File>,
    /// Its name in messages.
    name: String,
    scalar: Scalar,
    /// Number of numbers in a state.
    width: usize,
    /// Number of states.
    pub(super) count: usize,
    /// Number of states read so far.
    read: usize,
}

impl Reader {
    /// Opens a file whose states have numbers in arrays of these lengths, the outermost first.
    pub(super) fn open(path: &Path, lengths: &[usize]) -> Result<Self, Errors> {
        let file = File::open(path).map_err(|reason| unreadable(path, &reason))?;
        let about = file
            .metadata()
            .map_err(|reason| unreadable(path, &reason))?;
        let name = path.file_name().map_or(path.as_os_str(), |name| name);
        let name = name.to_string_lossy().into_owned();
        let mut bytes = BufReader::with_capacity(1 << 18, file);
        let (head, length) = head(&mut bytes).map_err(|why| mistake(format!("{name}: {why}")))?;
        let (scalar, count) = checked(&head, lengths, &name)?;
        let width = lengths.iter().product();
        let reader = Self {
            bytes,
            name,
            scalar,
            width,
            count,
            read: 0,
        };
        if about.is_file() {
            reader.check_length(about.len(), length)?;
        }
        Ok(reader)
    }

    fn check_length(&self, found: u64, head: usize) -> Result<(), Errors> {
        let numbers = self.count as u128 * self.width as u128;
        let expected = numbers * self.scalar.bytes() as u128 + head as u128;
        let (name, found) = (&self.name, u128::from(found));
        match found.cmp(&expected) {
            std::cmp::Ordering::Less => Err(mistake(format!(
                "{name}: is cut off: it has {found} of {expected} bytes"
            ))),
            std::cmp::Ordering::Equal => Ok(()),
            std::cmp::Ordering::Greater => Err(mistake(format!(
                "{name}: has {found} bytes, and {expected} by its head"
            ))),
        }
    }

    /// The numbers of the next states, one state after the other.
    pub(super) fn next(&mut self, states: usize) -> Result<Vec<f64>, Errors> {
        let each = self.scalar.bytes();
        let mut bytes = vec![0; states * self.width * each];
        self.bytes.read_exact(&mut bytes).map_err(|reason| {
            let name = &self.name;
            mistake(match reason.kind() {
                ErrorKind::UnexpectedEof => format!("{name}: ends after state {}", self.read),
                _ => format!("cannot read {name}: {reason}"),
            })
        })?;
        self.read += states;
        Ok(match self.scalar {
            Scalar::F32 => {
                let (numbers, _) = bytes.as_chunks();
                numbers
                    .iter()
                    .map(|&x| f32::from_le_bytes(x).into())
                    .collect()
            }
            Scalar::F64 => {
                let (numbers, _) = bytes.as_chunks();
                numbers.iter().map(|&x| f64::from_le_bytes(x)).collect()
            }
        })
    }
}

/// The content of a head.
#[derive(Debug, Default, PartialEq, Eq)]
struct Head {
    descr: Option<String>,
    fortran_order: Option<bool>,
    shape: Option<Vec<usize>>,
}

/// The head of a file and its number of bytes, or the end of a sentence that begins with the file.
fn head(bytes: &mut impl Read) -> Result<(Head, usize), String> {
    let mut take = |count: usize| {
        let mut taken = vec![0; count];
        bytes
            .read_exact(&mut taken)
            .map_err(|reason| match reason.kind() {
                ErrorKind::UnexpectedEof => {
                    "is not an .npy file: it ends within its head".to_owned()
                }
                _ => reason.to_string(),
            })?;
        Ok::<_, String>(taken)
    };
    let start = take(8)?;
    if !start.starts_with(MAGIC) {
        return Err("is not an .npy file: its first bytes are wrong".to_owned());
    }
    let version = start[6];
    let size = match version {
        1 => 2,
        2 | 3 => 4,
        _ => return Err(format!("is an .npy file of the unknown version {version}")),
    };
    let length = take(size)?;
    let length = length
        .iter()
        .rev()
        .fold(0_usize, |all, &byte| all << 8 | usize::from(byte));
    if length > LONGEST_HEAD {
        return Err(format!(
            "has a head of {length} bytes, which no array of numbers needs"
        ));
    }
    let text = take(length)?;
    let text = String::from_utf8_lossy(&text);
    let head = Words(text.trim()).dictionary();
    let head = head.ok_or_else(|| "has a head that NumPy does not write".to_owned())?;
    Ok((head, start.len() + size + length))
}

/// The rest of a head: the text of a dictionary in Python.
struct Words<'t>(&'t str);

impl<'t> Words<'t> {
    fn dictionary(mut self) -> Option<Head> {
        let mut head = Head::default();
        self.sign("{")?;
        while self.sign("}").is_none() {
            let key = self.string()?;
            self.sign(":")?;
            match key {
                // A list is a structured type.
                "descr" if self.0.starts_with('[') => {
                    let (whole, rest) = self.0.split_at(self.0.find(']')? + 1);
                    (head.descr, self.0) = (Some(whole.to_owned()), rest);
                }
                "descr" => head.descr = Some(self.string()?.to_owned()),
                "fortran_order" => {
                    let is_fortran = self.sign("True").map(|()| true);
                    head.fortran_order = Some(match is_fortran {
                        Some(is_fortran) => is_fortran,
                        None => self.sign("False").map(|()| false)?,
                    });
                }
                "shape" => head.shape = Some(self.shape()?),
                _ => return None,
            }
            if self.sign(",").is_none() && !self.0.starts_with('}') {
                return None;
            }
        }
        self.0.is_empty().then_some(head)
    }

    /// Skips a sign and the spaces after it.
    fn sign(&mut self, sign: &str) -> Option<()> {
        self.0 = self.0.strip_prefix(sign)?.trim_start();
        Some(())
    }

    fn string(&mut self) -> Option<&'t str> {
        let quote = self
            .0
            .chars()
            .next()
            .filter(|quote| ['\'', '"'].contains(quote))?;
        let (text, rest) = self.0[1..].split_once(quote)?;
        self.0 = rest.trim_start();
        Some(text)
    }

    fn shape(&mut self) -> Option<Vec<usize>> {
        self.sign("(")?;
        let (numbers, rest) = self.0.split_once(')')?;
        self.0 = rest.trim_start();
        let numbers = numbers.split(',').map(str::trim);
        // A comma is allowed after the last number.
        let numbers = numbers.filter(|number| !number.is_empty());
        numbers.map(|number| number.parse().ok()).collect()
    }
}

/// The type of number and the number of states, if the array has states with numbers in arrays of these lengths.
fn checked(head: &Head, lengths: &[usize], name: &str) -> Result<(Scalar, usize), Errors> {
    let refuse = |message: &str, hint: &str| {
        let mut errors = Errors::new();
        errors.push_with_hint(Place::Unknown, format!("{name}: {message}"), hint);
        errors
    };
    let (Some(descr), Some(fortran_order), Some(shape)) =
        (&head.descr, head.fortran_order, &head.shape)
    else {
        return Err(mistake(format!(
            "{name}: has a head without all of descr, fortran_order and shape"
        )));
    };
    let scalar = match descr.as_str() {
        "<f8" => Scalar::F64,
        "<f4" => Scalar::F32,
        other => {
            let message = format!("has numbers of the type {other}");
            return Err(refuse(
                &message,
                "save little-endian float64 or float32: array.astype('<f8')",
            ));
        }
    };
    let [count, each @ ..] = shape.as_slice() else {
        return Err(refuse(
            "has a single number instead of states",
            "the shape must be (states, numbers of each)",
        ));
    };
    if each != lengths {
        let wanted = shown(
            ["states".to_owned()]
                .into_iter()
                .chain(lengths.iter().map(ToString::to_string)),
        );
        let found = shown(shape.iter().map(ToString::to_string));
        let message = format!("has the shape {found} instead of {wanted}");
        let hint = match each {
            [] => "write one state as a row: array[None]",
            _ => "write one row for each state, in the order of `homogen check`",
        };
        return Err(refuse(&message, hint));
    }
    if fortran_order && *count > 1 {
        let hint = "save it in C order: numpy.ascontiguousarray(array)";
        return Err(refuse("is in Fortran order", hint));
    }
    Ok((scalar, *count))
}

/// A shape as Python writes it.
fn shown(lengths: impl Iterator<Item = String>) -> String {
    let lengths: Vec<String> = lengths.collect();
    match lengths.as_slice() {
        [only] => format!("({only},)"),
        all => format!("({})", all.join(", ")),
    }
}

/// A file of results.
pub(super) struct Writer {
    bytes: BufWriter<Fresh>,
    scalar: Scalar,
}

impl Writer {
    /// Begins a file of `states` states with numbers in arrays of these lengths.
    pub(super) fn create(
        path: &Path,
        scalar: Scalar,
        count: usize,
        lengths: &[usize],
    ) -> Result<Self, Errors> {
        let mut bytes = BufWriter::with_capacity(1 << 18, Fresh::create(path)?);
        let head = written(scalar, count, lengths);
        let begun = bytes.write_all(&head);
        begun.map_err(|reason| bytes.get_ref().refused(&reason))?;
        Ok(Self { bytes, scalar })
    }

    /// Writes the next numbers.
    pub(super) fn write(&mut self, numbers: &[f64]) -> Result<(), Errors> {
        let written = self.write_all(numbers);
        written.map_err(|reason| self.bytes.get_ref().refused(&reason))
    }

    fn write_all(&mut self, numbers: &[f64]) -> io::Result<()> {
        numbers.iter().try_for_each(|&number| match self.scalar {
            #[expect(
                clippy::cast_possible_truncation,
                reason = "it was in single precision"
            )]
            Scalar::F32 => self.bytes.write_all(&(number as f32).to_le_bytes()),
            Scalar::F64 => self.bytes.write_all(&number.to_le_bytes()),
        })
    }

    /// The file, complete under its temporary name.
    pub(super) fn complete(self) -> Result<Fresh, Errors> {
        let file = self.bytes.into_inner();
        let file = file.map_err(|error| {
            let (reason, bytes) = error.into_parts();
            bytes.get_ref().refused(&reason)
        });
        file?.complete()
    }
}

/// The head of an array, as `numpy.save` writes it.
fn written(scalar: Scalar, count: usize, lengths: &[usize]) -> Vec<u8> {
    let descr = match scalar {
        Scalar::F32 => "<f4",
        Scalar::F64 => "<f8",
    };
    let shape = shown([&count].into_iter().chain(lengths).map(ToString::to_string));
    let mut text = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}");
    // The numbers begin at a multiple of 64 bytes; a newline ends the head.
    let before = MAGIC.len() + 4;
    let padded = (before + text.len() + 1).next_multiple_of(64) - before;
    text.extend(std::iter::repeat_n(' ', padded - text.len() - 1));
    text.push('\n');
    let length = u16::try_from(text.len()).expect("an array has a few axes");
    let mut head = MAGIC.to_vec();
    head.extend([1, 0]);
    head.extend(length.to_le_bytes());
    head.extend(text.into_bytes());
    head
}
