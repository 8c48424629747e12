//! Form and kind of steps: the operation that a value comes from, and the vector that it belongs to.
//!
//! In: a step and its label. Out: which values are bounded together as one vector, and which steps are replaced by
//! their operands.

use super::rotation::{PlaneRotation, SineOrCosine};
use super::value::Value;
use crate::expression::{Component, Label, Quantity};
use crate::schedule::{Operand, Operation, Step};

/// Form of a step, as far as rotations are concerned.
#[derive(Clone, Copy, Debug)]
pub enum StepForm {
    /// Entry of a vector that is rotated by an angle.
    ByRotation(PlaneRotation),
    /// a ± b.
    Sum(Operand, Operand),
    /// The operand plus or minus an intermediate value with this range and error.
    More(Operand, Value),
    /// Any other operation.
    Plain,
}

/// A value that is not a linear combination with literals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Monomial {
    /// Operand.
    Whole(Operand),
    /// Product within a fused operation, or of a step of its own.
    Product(Operand, Operand),
}

/// Vector that a column belongs to, according to labels and factors. A wrong guess makes bounds larger, not wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ColumnKind {
    /// Entries of one labelled vector; for an inertia, first moments and mass.
    Entries(Quantity),
    /// Second moments of one row.
    Row(Quantity, usize),
    /// Entries of a vector that is rotated by an angle, or its sine and cosine.
    ByRotation(u32),
    /// Entries of a vector that a rotation matrix multiplies; with the root sum square of the errors of the matrix.
    Rotated(f64),
    /// Products with this factor.
    Times(Operand),
    /// No vector.
    Alone(Operand),
}

/// True for a sum or difference, fused or not.
pub const fn is_sum(operation: Operation) -> bool {
    operation.is_fused() || matches!(operation, Operation::Add(..) | Operation::Sub(..))
}

/// Condition for the substitution of the operands of a step for the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follows {
    /// Always: it has no label.
    Always,
    /// Only if its own bound was asked for.
    First,
    /// Never: it is neither a sum nor a product, or it is an entry of a rotated vector.
    Never,
}

impl Follows {
    /// Condition for a step.
    pub const fn of(step: &Step, form: &StepForm) -> Self {
        let combines = is_sum(step.operation) || matches!(step.operation, Operation::Mul(..));
        match (combines, form, &step.label) {
            (false, ..) | (_, StepForm::ByRotation(_), _) => Self::Never,
            (_, _, Some(_)) => Self::First,
            (_, _, None) => Self::Always,
        }
    }
}

impl ColumnKind {
    /// Kind of an operand.
    pub fn of(
        operand: Operand,
        label: Option<Label>,
        form: &StepForm,
        place: Option<SineOrCosine>,
    ) -> Self {
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
            (Some(SineOrCosine { angle, .. }), _)
            | (None, &StepForm::ByRotation(PlaneRotation { angle, .. })) => Self::ByRotation(angle),
            _ => Self::Alone(operand),
        }
    }
}
