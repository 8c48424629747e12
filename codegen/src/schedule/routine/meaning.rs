//! Meanings of the names in a routine.
//!
//! In: the meaning of a value. Out: its preferred identifier in generated code.

use std::fmt;

use crate::expression::Label;
use crate::space::{Variable, action_entry};

/// Meaning of a name in a routine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// An entry of an argument, by its index.
    Argument(Variable, u16),
    /// An entry of a matrix.
    Entry(Label),
    /// A sum of coordinates, by their indices.
    Sum(Vec<u16>),
    /// The sine of an angle.
    Sine(RotationAngle),
    /// The cosine of an angle.
    Cosine(RotationAngle),
    /// A part of a sum or product, by its number from 1 on.
    Part(usize),
    /// The table that a loop reads its columns from; loops count from 1.
    Table(usize),
    /// The table that a loop writes its results to.
    Found(usize),
    /// The index of all loops, none of which is within another.
    LoopIndex,
}

/// The angle of a sine and a cosine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RotationAngle {
    /// The name of its value; `a` if it has none.
    pub name: String,
    /// The coordinates that it is the sum of, by their indices; empty for any other angle.
    pub coordinates: Vec<u16>,
}

/// The identifier, not necessarily unique in a routine: `q_3`, `w_0_3_in_3_x`, `s_2_3`, `t_7`.
impl fmt::Display for Meaning {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Argument(Variable::Actions, entry) => {
                let (action, entry) = action_entry(usize::from(*entry));
                write!(out, "action_{}_{entry}", action + 1)
            }
            Self::Argument(argument, entry) => write!(out, "{}_{}", argument.name(), entry + 1),
            Self::Entry(label) => label.fmt(out),
            Self::Sum(coordinates) => write!(out, "q_{}", numbers(coordinates)),
            Self::Sine(turn) => write!(out, "s_{turn}"),
            Self::Cosine(turn) => write!(out, "c_{turn}"),
            Self::Part(number) => write!(out, "t_{number}"),
            Self::Table(number) => of_loop(out, "columns", *number),
            Self::Found(number) => of_loop(out, "found", *number),
            Self::LoopIndex => out.write_str("i"),
        }
    }
}

/// `2`, `2_3` for q₂ + q₃, or the name of the value.
impl fmt::Display for RotationAngle {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &*self.coordinates {
            [] => out.write_str(&self.name),
            coordinates => out.write_str(&numbers(coordinates)),
        }
    }
}

/// `columns`, and `columns_2` of the second loop.
fn of_loop(out: &mut fmt::Formatter<'_>, word: &str, number: usize) -> fmt::Result {
    match number {
        1 => out.write_str(word),
        number => write!(out, "{word}_{number}"),
    }
}

/// Coordinates as the paper counts them, from 1.
fn numbers(coordinates: &[u16]) -> String {
    let numbers: Vec<_> = coordinates.iter().map(|k| (k + 1).to_string()).collect();
    numbers.join("_")
}
