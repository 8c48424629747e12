//! The last form before tokens: a flat list of operations in the order in which they run.
//!
//! In: a graph and the expressions asked for. Out: a [`Program`] that holds what is needed and
//! nothing else; emission, evaluation and counting all read it and never look at the graph again.

mod blocks;
pub mod bound;
mod fuse;
mod order;
mod price;
mod run;
mod signs;

pub use blocks::{Block, LONGEST_SCOPE, Part, nested};
pub use order::{schedule, schedule_unfused};
pub use price::Price;
pub use run::run;

pub use crate::expression::Arithmetic;
use crate::expression::Input;

/// One generated function, ready to be printed, run or counted.
#[derive(Clone, Debug)]
pub struct Program {
    /// The arguments of all sines and cosines, evaluated together after `steps[..before_angles]`.
    pub angles: Vec<Operand>,
    /// How many steps come before the sines and cosines.
    pub before_angles: usize,
    /// The operations; an operand [`Operand::Step`] always refers to an earlier one.
    pub steps: Vec<Step>,
    /// The results, in the order of the function's shape; of several functions one after the other.
    pub results: Vec<Operand>,
}

/// One operation and the name of its result.
#[derive(Clone, Debug)]
pub struct Step {
    /// The entry of a matrix that the result is (`w_0_3_in_3_x`); none where it is only a part of
    /// one. A valid Rust identifier, not necessarily unique in a program.
    pub label: Option<String>,
    /// What is computed.
    pub operation: Operation,
}

/// An operation of IEEE 754.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    /// a + b.
    Add(Operand, Operand),
    /// a − b.
    Sub(Operand, Operand),
    /// a b.
    Mul(Operand, Operand),
    /// a / b.
    Div(Operand, Operand),
    /// √a.
    Sqrt(Operand),
    /// −a.
    Neg(Operand),
    /// a b + c, rounded once where the target can.
    MulAdd(Operand, Operand, Operand),
    /// a b − c, rounded once where the target can.
    MulSub(Operand, Operand, Operand),
    /// c − a b, rounded once where the target can.
    NegMulAdd(Operand, Operand, Operand),
}

/// What an operation acts on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// A number known at generation.
    Literal(f64),
    /// An argument or a run-time parameter.
    Input(Input),
    /// The sine of the angle of that index.
    Sin(u32),
    /// The cosine of the angle of that index.
    Cos(u32),
    /// The result of an earlier step.
    Step(u32),
}

impl Operation {
    /// Whether it is a product and a sum at once.
    #[must_use]
    pub const fn is_fused(&self) -> bool {
        matches!(
            self,
            Self::MulAdd(..) | Self::MulSub(..) | Self::NegMulAdd(..)
        )
    }

    /// What it acts on.
    #[must_use]
    pub fn operands(&self) -> Vec<Operand> {
        match *self {
            Self::Sqrt(a) | Self::Neg(a) => vec![a],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![a, b],
            Self::MulAdd(a, b, c) | Self::MulSub(a, b, c) | Self::NegMulAdd(a, b, c) => {
                vec![a, b, c]
            }
        }
    }
}

impl Program {
    /// Everything that is read, by steps, by angles and by results; with repetition.
    pub fn operands(&self) -> impl Iterator<Item = Operand> {
        let steps = self.steps.iter();
        steps
            .flat_map(|step| step.operation.operands())
            .chain(self.angles.iter().copied())
            .chain(self.results.iter().copied())
    }
}
