//! Errors of batches: slices of different lengths.
//!
//! In: the lengths of the slices of a call. Out: an error for the first that differs.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// The error of a batch: a slice is not as long as `q`. No result is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BatchError {
    /// The argument's name: `qd`, `qdd`, `tau`, or `results`.
    pub argument: &'static str,
    /// The number of its states.
    pub length: usize,
    /// The number of states in `q`.
    pub expected: usize,
}

impl Display for BatchError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self {
            argument,
            length,
            expected,
        } = self;
        write!(f, "`{argument}` has {length} states, `q` has {expected}")
    }
}

impl Error for BatchError {}

/// The error of a batch of [columns](super::Columns). No result is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnsError {
    /// A column is not as long as the first column of `q`.
    Length {
        /// The argument's name: `q`, `qd`, `qdd`, `tau`, or `results`.
        argument: &'static str,
        /// The index of the column, from 0.
        column: usize,
        /// The number of its states.
        length: usize,
        /// The number of states in the first column of `q`.
        expected: usize,
    },
    /// The number of columns of `results` is not the number of numbers in a result.
    Count {
        /// The number of columns.
        columns: usize,
        /// The number of numbers in the result of one state.
        expected: usize,
    },
}

impl Display for ColumnsError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length {
                argument,
                column,
                length,
                expected,
            } => write!(
                f,
                "column {column} of `{argument}` has {length} states, the first of `q` has {expected}"
            ),
            Self::Count { columns, expected } => {
                write!(
                    f,
                    "`results` has {columns} columns, a result has {expected} numbers"
                )
            }
        }
    }
}

impl Error for ColumnsError {}

/// Rejects slices that are not as long as the first.
pub(super) fn check(slices: &[(&'static str, usize)]) -> Result<(), BatchError> {
    let expected = slices.first().map_or(0, |(_, length)| *length);
    let wrong = slices.iter().find(|(_, length)| *length != expected);
    wrong.map_or(Ok(()), |(argument, length)| {
        Err(BatchError {
            argument,
            length: *length,
            expected,
        })
    })
}
