//! How the value of a step came about, and what it has in common with others.
//!
//! In: a step, and its label. Out: what is to be taken together, and
//! what is put in the place of what came from it. It never looks at how large a value is.

use super::turn::{Place, Turn};
use super::value::Value;
use crate::expression::{Component, Label, Quantity};
use crate::schedule::{Operand, Operation, Step};

/// How a value came about, as far as turns are concerned.
#[derive(Clone, Copy, Debug)]
pub enum Form {
    /// An entry of a turned vector.
    Turned(Turn),
    /// a ± b.
    Sum(Operand, Operand),
    /// The first, plus or minus something of that value that has no place of its own.
    More(Operand, Value),
    /// Nothing that helps.
    Plain,
}

/// A value that no number has made of others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Of {
    /// A value with a place of its own.
    Whole(Operand),
    /// A product within a fused operation, or a step that is one.
    Product(Operand, Operand),
}

/// The vector that columns belong to, as far as labels and factors show.
/// A wrong guess costs sharpness, not truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Entries of one vector; of an inertia, of first moments and mass.
    Entries(Quantity),
    /// Second moments of one row.
    Row(Quantity, usize),
    /// Entries of a turned vector, or sine and cosine themselves.
    Turned(u32),
    /// Entries of a vector that a rotation matrix multiplies, with √(δ² + …) of the errors of its entries.
    Rotated(f64),
    /// Products with this.
    Times(Operand),
    /// By itself.
    Alone(Operand),
}

/// Whether an operation is a sum.
pub const fn is_sum(operation: Operation) -> bool {
    operation.is_fused() || matches!(operation, Operation::Add(..) | Operation::Sub(..))
}

/// Whether what a step came from is put in its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follows {
    /// It has no name, so that it is nothing but a part.
    Always,
    /// Where it was asked for itself.
    First,
    /// It is no sum, or the entry of a turned vector.
    Never,
}

impl Follows {
    /// Of a step.
    pub const fn of(step: &Step, form: &Form) -> Self {
        let combines = is_sum(step.operation) || matches!(step.operation, Operation::Mul(..));
        match (combines, form, &step.label) {
            (false, ..) | (_, Form::Turned(_), _) => Self::Never,
            (_, _, Some(_)) => Self::First,
            (_, _, None) => Self::Always,
        }
    }
}

impl Kind {
    /// What a step has in common with others.
    pub fn of(operand: Operand, label: Option<Label>, form: &Form, place: Option<Place>) -> Self {
        if let Some(Label {
            quantity,
            component,
            ..
        }) = label
        {
            return match component {
                Component::Second(row, _) => Self::Row(quantity, row),
                Component::Scalar | Component::Along(_) | Component::Mass => {
                    Self::Entries(quantity)
                }
            };
        }
        match (place, form) {
            (Some(Place { angle, .. }), _) | (None, &Form::Turned(Turn { angle, .. })) => {
                Self::Turned(angle)
            }
            _ => Self::Alone(operand),
        }
    }
}
