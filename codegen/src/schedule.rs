//! Programs: flat lists of operations in execution order, and routines, which add names for printing.
//!
//! In: a graph and the expressions of the results. Out: a [`Program`] with the operations that they need, and its
//! [`Routine`]. Printing, evaluation and counting read these and not the graph.

mod arranged;
mod blocks;
pub mod bound;
mod fuse;
mod inlined;
mod lanes;
mod limbs;
mod names;
mod once;
mod operation_count;
mod order;
mod parts;
mod readers;
mod repeats;
mod routine;
mod run;
mod sections;
mod signs;
mod sums;

pub use arranged::Arranged;
pub use blocks::LONGEST_SCOPE;
pub use lanes::{LANES, Lanes};
pub use limbs::fused_alike;
pub use names::Names;
pub(crate) use names::sanitize;
pub use once::{SeparatedPrograms, part};
pub use operation_count::OperationCount;
pub use order::{schedule, schedule_unfused};
pub use routine::{
    Angle, Cells, Entries, LoopTable, Meaning, Readable, RotationAngle, Routine, RoutineLoop,
    SectionBody, Statement, StorePlace, Stored, Value, Work,
};
pub use run::run;
pub use sections::{Length, Sections};

use std::collections::BTreeMap;

pub use crate::expression::Arithmetic;
use crate::expression::{Input, Label};

/// Operations of one generated function.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// Angles of all sines and cosines, evaluated together after `steps[..before_angles]`.
    pub angles: Vec<Operand>,
    /// Number of steps before the sines and cosines.
    pub before_angles: usize,
    /// Operations; an operand [`Operand::Step`] always refers to an earlier one.
    pub steps: Vec<Step>,
    /// Results in the order of the function's result; those of several functions one after the other.
    pub results: Vec<Operand>,
    /// Error bounds of literals, by the bits of their magnitudes: for literals that cancellation leaves with an error,
    /// even in 106 bits, that matters beside their rounding to `f64`.
    pub open: BTreeMap<u64, f64>,
}

/// One operation and the name of its result.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Matrix entry that the result is; `None` for an intermediate value.
    pub label: Option<Label>,
    /// Operation.
    pub operation: Operation,
}

/// An operation of IEEE 754, in a program on [`Operand`]s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation<T = Operand> {
    /// a + b.
    Add(T, T),
    /// a − b.
    Sub(T, T),
    /// a b.
    Mul(T, T),
    /// a / b.
    Div(T, T),
    /// √a.
    Sqrt(T),
    /// The sign of a: −1, 0 or 1.
    Sign(T),
    /// −a.
    Neg(T),
    /// a b + c, rounded once where the target can.
    MulAdd(T, T, T),
    /// a b − c, rounded once where the target can.
    MulSub(T, T, T),
    /// c − a b, rounded once where the target can.
    NegMulAdd(T, T, T),
}

/// Operand of an operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// A number known at generation.
    Literal(f64),
    /// An argument or a run-time parameter.
    Input(Input),
    /// The sine of the angle with this index.
    Sin(u32),
    /// The cosine of the angle with this index.
    Cos(u32),
    /// The result of an earlier step.
    Step(u32),
}

impl<T> Operation<T> {
    /// True if it combines a product and a sum.
    #[must_use]
    pub const fn is_fused(&self) -> bool {
        matches!(
            self,
            Self::MulAdd(..) | Self::MulSub(..) | Self::NegMulAdd(..)
        )
    }

    /// The same operation on mapped operands.
    pub fn map<U>(self, mut of: impl FnMut(T) -> U) -> Operation<U> {
        match self {
            Self::Add(a, b) => Operation::Add(of(a), of(b)),
            Self::Sub(a, b) => Operation::Sub(of(a), of(b)),
            Self::Mul(a, b) => Operation::Mul(of(a), of(b)),
            Self::Div(a, b) => Operation::Div(of(a), of(b)),
            Self::Sqrt(a) => Operation::Sqrt(of(a)),
            Self::Sign(a) => Operation::Sign(of(a)),
            Self::Neg(a) => Operation::Neg(of(a)),
            Self::MulAdd(a, b, c) => Operation::MulAdd(of(a), of(b), of(c)),
            Self::MulSub(a, b, c) => Operation::MulSub(of(a), of(b), of(c)),
            Self::NegMulAdd(a, b, c) => Operation::NegMulAdd(of(a), of(b), of(c)),
        }
    }
}

impl<T: Copy> Operation<T> {
    /// Operands.
    #[must_use]
    pub fn operands(&self) -> Vec<T> {
        match *self {
            Self::Sqrt(a) | Self::Sign(a) | Self::Neg(a) => vec![a],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![a, b],
            Self::MulAdd(a, b, c) | Self::MulSub(a, b, c) | Self::NegMulAdd(a, b, c) => {
                vec![a, b, c]
            }
        }
    }
}

impl Program {
    /// All operands that steps, angles and results read, with repetition.
    pub fn operands(&self) -> impl Iterator<Item = Operand> {
        let steps = self.steps.iter();
        steps
            .flat_map(|step| step.operation.operands())
            .chain(self.angles.iter().copied())
            .chain(self.results.iter().copied())
    }

    /// True if a step is a square root.
    #[must_use]
    pub fn has_roots(&self) -> bool {
        let mut steps = self.steps.iter();
        steps.any(|step| matches!(step.operation, Operation::Sqrt(_)))
    }

    /// True if a step is the sign of a number.
    #[must_use]
    pub fn has_signs(&self) -> bool {
        let mut steps = self.steps.iter();
        steps.any(|step| matches!(step.operation, Operation::Sign(_)))
    }
}

/// Index of a step.
fn number(step: usize) -> u32 {
    u32::try_from(step).expect("fewer than 2³² steps")
}
