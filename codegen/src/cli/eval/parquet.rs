//! Tables in Parquet, some rows at a time: a row a state, a column an argument or a result.
//!
//! In: a file whose columns are lists of as many numbers as the arguments have, `DOUBLE` or `FLOAT`, under their
//! names; other columns are left alone. Or columns of results, which are written as such lists, matrices row by row.
//! It never has more than some rows in memory, and never converts a number but from single to double precision.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use ::parquet::basic::Type as Physical;
use ::parquet::column::reader::ColumnReader;
use ::parquet::column::writer::ColumnWriter;
use ::parquet::errors::ParquetError;
use ::parquet::file::properties::{EnabledStatistics, WriterProperties};
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::parser::parse_message_type;
use ::parquet::schema::types::SchemaDescriptor;

use super::super::fresh::Fresh;
use super::super::options::{Scalar, mistake, unreadable};
use super::answer::Layout;
use crate::error::{Errors, Place};
use crate::space::{Spaces, Variable};

/// A table that states are read from.
pub(super) struct Reader {
    file: SerializedFileReader<File>,
    /// What messages call it.
    name: String,
    columns: Vec<Column>,
    /// How many states there are.
    pub(super) count: usize,
    /// How many have been read.
    read: usize,
    /// The group of rows that comes next.
    group: usize,
    /// How many rows of the current group are left.
    left: usize,
}

/// An argument.
struct Column {
    name: &'static str,
    /// Which of the file's columns it is.
    leaf: usize,
    /// How many numbers a state has.
    width: usize,
    /// The level of definition of a number that is there.
    defined: i16,
    /// The level of repetition of a number that is not the first of its state; 0 where there is one a state.
    repeated: i16,
    /// What reads the current group of rows.
    reader: Option<ColumnReader>,
}

impl Reader {
    /// Opens a table that has these arguments.
    pub(super) fn open(
        path: &Path,
        arguments: &[Variable],
        spaces: &Spaces,
    ) -> Result<Self, Errors> {
        let name = path.file_name().map_or(path.as_os_str(), |name| name);
        let name = name.to_string_lossy().into_owned();
        let file = File::open(path).map_err(|reason| unreadable(path, &reason))?;
        let file = SerializedFileReader::new(file).map_err(|reason| refused(&name, &reason))?;
        let about = file.metadata().file_metadata();
        let mut errors = Errors::new();
        let mut columns = Vec::new();
        for argument in arguments {
            match column(
                about.schema_descr(),
                argument.name(),
                spaces.len(argument.space()),
            ) {
                Ok(column) => columns.push(column),
                Err(why) => errors.push(Place::Unknown, format!("{name}: {why}")),
            }
        }
        let count = usize::try_from(about.num_rows()).unwrap_or_default();
        errors.into_result(Self {
            file,
            name,
            columns,
            count,
            read: 0,
            group: 0,
            left: 0,
        })
    }

    /// The numbers of each argument at the next states.
    pub(super) fn next(&mut self, states: usize) -> Result<Vec<Vec<f64>>, Errors> {
        let mut numbers = vec![Vec::new(); self.columns.len()];
        let mut wanted = states;
        while wanted > 0 {
            if self.left == 0 {
                self.next_group()
                    .map_err(|reason| refused(&self.name, &reason))?;
                continue;
            }
            let rows = wanted.min(self.left);
            for (column, numbers) in self.columns.iter_mut().zip(&mut numbers) {
                let read = column
                    .read(rows, numbers)
                    .map_err(|reason| refused(&self.name, &reason))?;
                read.map_err(|Odd(row, why)| {
                    let state = self.read + row;
                    mistake(format!(
                        "{}: state {state} has {why} in \"{}\"",
                        self.name, column.name
                    ))
                })?;
            }
            self.read += rows;
            self.left -= rows;
            wanted -= rows;
        }
        Ok(numbers)
    }

    fn next_group(&mut self) -> Result<(), ParquetError> {
        if self.group == self.file.num_row_groups() {
            return Err(ParquetError::General(
                "it has fewer rows than it says".to_owned(),
            ));
        }
        let rows = self.file.get_row_group(self.group)?;
        self.left = usize::try_from(rows.metadata().num_rows()).unwrap_or_default();
        for column in &mut self.columns {
            column.reader = Some(rows.get_column_reader(column.leaf)?);
        }
        self.group += 1;
        Ok(())
    }
}

/// The column of that name, or the end of a sentence that begins with the file.
fn column(schema: &SchemaDescriptor, name: &'static str, width: usize) -> Result<Column, String> {
    let leaves = schema.columns().iter().enumerate();
    let mut leaves =
        leaves.filter(|(_, leaf)| leaf.path().parts().first().is_some_and(|part| part == name));
    let Some((leaf, about)) = leaves.next() else {
        return Err(format!("has no column \"{name}\""));
    };
    if leaves.next().is_some() {
        return Err(format!(
            "has a column \"{name}\" that is a structure and no list"
        ));
    }
    let kind = about.physical_type();
    if !matches!(kind, Physical::DOUBLE | Physical::FLOAT) {
        return Err(format!(
            "has a column \"{name}\" of {kind}, and not of DOUBLE or FLOAT"
        ));
    }
    if about.max_rep_level() == 0 && width != 1 {
        return Err(format!(
            "has one number a state in \"{name}\" for {width} joints"
        ));
    }
    Ok(Column {
        name,
        leaf,
        width,
        defined: about.max_def_level(),
        repeated: about.max_rep_level(),
        reader: None,
    })
}

/// A row that has something else than its numbers, by what follows "state 3 has".
struct Odd(usize, String);

impl Column {
    /// Reads some rows of the current group.
    fn read(
        &mut self,
        rows: usize,
        numbers: &mut Vec<f64>,
    ) -> Result<Result<(), Odd>, ParquetError> {
        let (mut definition, mut repetition) = (Vec::new(), Vec::new());
        let levels = (self.defined > 0).then_some(&mut definition);
        let again = (self.repeated > 0).then_some(&mut repetition);
        let (read, _, _) = match &mut self.reader {
            Some(ColumnReader::DoubleColumnReader(reader)) => {
                reader.read_records(rows, levels, again, numbers)?
            }
            Some(ColumnReader::FloatColumnReader(reader)) => {
                let mut singles = Vec::new();
                let read = reader.read_records(rows, levels, again, &mut singles)?;
                numbers.extend(singles.into_iter().map(f64::from));
                read
            }
            _ => unreachable!("it has been looked at when the file was opened"),
        };
        if read < rows {
            let message = format!("column {} ends after {read} of {rows} rows", self.name);
            return Err(ParquetError::General(message));
        }
        Ok(self.check(&definition, &repetition))
    }

    /// Whether every row has as many numbers as the argument.
    fn check(&self, definition: &[i16], repetition: &[i16]) -> Result<(), Odd> {
        let is_first = |&(_, &level): &(usize, &i16)| level == 0;
        let missing = definition.iter().position(|&level| level < self.defined);
        if self.repeated == 0 {
            return missing.map_or(Ok(()), |row| Err(Odd(row, "no number".to_owned())));
        }
        let mut starts: Vec<usize> = repetition
            .iter()
            .enumerate()
            .filter(is_first)
            .map(|(k, _)| k)
            .collect();
        starts.push(repetition.len());
        for (row, places) in starts.windows(2).enumerate() {
            let levels = &definition[places[0]..places[1]];
            let found = levels
                .iter()
                .filter(|&&level| level == self.defined)
                .count();
            if found != self.width {
                return Err(Odd(row, format!("{found} numbers for {}", self.width)));
            }
            if levels.len() > found && found > 0 {
                return Err(Odd(row, "a null".to_owned()));
            }
        }
        Ok(())
    }
}

fn refused(name: &str, reason: &ParquetError) -> Errors {
    mistake(format!("{name}: cannot be read as Parquet: {reason}"))
}

/// A table that results are written to.
pub(super) struct Writer {
    file: SerializedFileWriter<Fresh>,
    /// What messages call it.
    path: PathBuf,
    scalar: Scalar,
    /// How many numbers a state has of each result; none of one that is a number by itself.
    widths: Vec<Option<usize>>,
}

impl Writer {
    /// Begins a table with a column for each result.
    pub(super) fn create(path: &Path, layout: &Layout<'_>) -> Result<Self, Errors> {
        let kind = match layout.scalar {
            Scalar::F32 => "float",
            Scalar::F64 => "double",
        };
        let columns = layout.names().zip(&layout.results);
        let columns = columns.map(|(name, result)| match &*result.lengths {
            [] => format!("required {kind} {name};"),
            _ => format!(
                "required group {name} (LIST) {{ repeated group list {{ required {kind} element; }} }}"
            ),
        });
        let schema = format!("message states {{ {} }}", columns.collect::<String>());
        let schema = parse_message_type(&schema).expect("names of functions are words");
        // Random digits have no repetition to gain from.
        let properties = WriterProperties::builder()
            .set_created_by(concat!("homogen ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::None)
            .build();
        let fresh = Fresh::create(path)?;
        let file = SerializedFileWriter::new(fresh, Arc::new(schema), Arc::new(properties));
        let file = file.map_err(|reason| unwritten(path, &reason))?;
        let widths = layout.results.iter().map(|result| match &*result.lengths {
            [] => None,
            lengths => Some(lengths.iter().product()),
        });
        Ok(Self {
            file,
            path: path.to_owned(),
            scalar: layout.scalar,
            widths: widths.collect(),
        })
    }

    /// Writes some rows, as a group, from the numbers of each column.
    pub(super) fn write(&mut self, columns: &[Vec<f64>], states: usize) -> Result<(), Errors> {
        let written = self.write_group(columns, states);
        written.map_err(|reason| unwritten(&self.path, &reason))
    }

    fn write_group(&mut self, columns: &[Vec<f64>], states: usize) -> Result<(), ParquetError> {
        let mut group = self.file.next_row_group()?;
        for (numbers, width) in columns.iter().zip(&self.widths) {
            let Some(mut column) = group.next_column()? else {
                unreachable!("there is a column for each result");
            };
            let (definition, repetition) = match width {
                None => (None, None),
                Some(width) => {
                    let (definition, repetition) = levels(*width, states);
                    (Some(definition), Some(repetition))
                }
            };
            let levels = (definition.as_deref(), repetition.as_deref());
            match column.untyped() {
                ColumnWriter::DoubleColumnWriter(writer) => {
                    writer.write_batch(numbers, levels.0, levels.1)?;
                }
                ColumnWriter::FloatColumnWriter(writer) => {
                    #[expect(
                        clippy::cast_possible_truncation,
                        reason = "they have been of single precision"
                    )]
                    let numbers: Vec<f32> = numbers.iter().map(|&number| number as f32).collect();
                    writer.write_batch(&numbers, levels.0, levels.1)?;
                }
                _ => unreachable!("the columns are of {:?}", self.scalar),
            }
            column.close()?;
        }
        group.close()?;
        Ok(())
    }

    /// The file, complete under its passing name.
    pub(super) fn complete(self) -> Result<Fresh, Errors> {
        let file = self.file.into_inner();
        let file = file.map_err(|reason| unwritten(&self.path, &reason));
        file?.complete()
    }
}

fn unwritten(path: &Path, reason: &ParquetError) -> Errors {
    let told = match reason {
        ParquetError::External(reason) => reason.to_string(),
        other => other.to_string(),
    };
    mistake(format!("cannot write {}: {told}", path.display()))
}

/// The levels of definition and repetition of lists of that many numbers; an empty list has levels and no number.
fn levels(width: usize, states: usize) -> (Vec<i16>, Vec<i16>) {
    let definition = vec![i16::from(width > 0); states * width.max(1)];
    let of_a_state = (0..width.max(1)).map(|k| i16::from(k > 0));
    let of_a_state: Vec<i16> = of_a_state.collect();
    (definition, of_a_state.repeat(states))
}
