//! How the value of a step came about, and what it has in common with others.
//!
//! In: a step, and the names of matrices that its label tells. Out: what is to be taken together, and
//! what is put in the place of what came from it. It never looks at how large a value is.

use std::collections::HashMap;

use super::turn::{Place, Turn};
use super::value::Value;
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

/// What columns have in common whose values are entries of one vector, as far as names and factors
/// tell. A wrong guess costs sharpness, not truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Entries of a matrix of the name with this number.
    Named(u32),
    /// Entries of a turned vector, or sine and cosine themselves.
    Turned(u32),
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

/// The names of matrices, as far as labels of entries tell.
#[derive(Default)]
pub struct Names<'p>(HashMap<&'p str, u32>);

impl<'p> Names<'p> {
    /// What a step has in common with others.
    pub fn kind(
        &mut self,
        operand: Operand,
        label: Option<&'p str>,
        form: &Form,
        place: Option<Place>,
    ) -> Kind {
        if let Some(label) = label {
            let label = label.strip_prefix("minus_").unwrap_or(label);
            // The last letter tells the entry.
            let end = label.char_indices().next_back().map_or(0, |(at, _)| at);
            let next = u32::try_from(self.0.len()).expect("fewer than steps");
            return Kind::Named(*self.0.entry(&label[..end]).or_insert(next));
        }
        match (place, form) {
            (Some(Place { angle, .. }), _) | (None, &Form::Turned(Turn { angle, .. })) => {
                Kind::Turned(angle)
            }
            _ => Kind::Alone(operand),
        }
    }
}
