//! Slices that do not belong together.
//!
//! In: the lengths of what a call was given. Out: one error for the first that differs. It looks at no
//! state.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// Why a batch was refused: a slice is not as long as the coordinates. Nothing was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BatchError {
    /// The slice, as the argument is called: `qd`, `qdd`, `tau`, or `results`.
    pub argument: &'static str,
    /// How many states it has.
    pub length: usize,
    /// How many states `q` has.
    pub expected: usize,
}

impl Display for BatchError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self {
            argument,
            length,
            expected,
        } = self;
        write!(
            f,
            "`{argument}` has a length of {length}, and `q` of {expected}"
        )
    }
}

impl Error for BatchError {}

/// Why a batch of [columns](super::Columns) was refused. Nothing was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnsError {
    /// A column is not as long as the first one of the coordinates.
    Length {
        /// What it is a column of, as the argument is called: `q`, `qd`, `qdd`, `tau`, or `results`.
        argument: &'static str,
        /// Which one it is, from 0.
        column: usize,
        /// How many states it has.
        length: usize,
        /// How many states there are.
        expected: usize,
    },
    /// The results are not as many columns as a state has numbers.
    Count {
        /// How many there are.
        columns: usize,
        /// How many numbers a state has.
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
                "column {column} of `{argument}` has a length of {length}, and the first of `q` of {expected}"
            ),
            Self::Count { columns, expected } => {
                write!(
                    f,
                    "the result has {expected} numbers, and `results` {columns} columns"
                )
            }
        }
    }
}

impl Error for ColumnsError {}

/// Whether all slices are as long as the first.
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
