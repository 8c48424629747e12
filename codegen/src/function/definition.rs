//! What is to be known of a function: a value of this type stands in the file of each.

use super::tally::{Size, Tally};
use crate::dense::{Approximate, Dense};
use crate::expression::Term;
use crate::model::{Scene, Way};
use crate::space::{FrameId, Outcome, Variable};

/// What the results of a function are held against, whatever way they were found.
#[derive(Clone, Copy)]
pub(crate) enum Truth {
    /// What dense matrices make of a state; of the frame of that index where it is of one.
    Value(fn(&Dense, FrameId) -> Vec<Approximate>),
    /// The same, of robots that have mass: without any there is no such thing.
    OfMass(fn(&Dense, FrameId) -> Vec<Approximate>),
    /// The same of what is solved for where loops hold joints together, and so small a part of the whole is
    /// nothing.
    Constrained(fn(&Dense, f64) -> Vec<Approximate>),
    /// An equation that they solve, in which that is given.
    Solution(Given),
}

/// What a solution is found for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// τ, of which accelerations are the solution.
    Torques,
    /// M, of which each column of the inverse is one, from the diagonal up: each for another M.
    MassMatrix,
    /// ∂τ/∂q and ∂τ/∂q̇ at the accelerations of τ, which decide these, of which each column of the derivatives of
    /// accelerations is one.
    TorqueDerivatives,
}

/// A property of a function that others do not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Property {
    /// It is about a frame, the tip's or a further one, and not about the whole robot.
    Frame,
    /// Masses and moments of inertia are numbers of it, and not factors of its result.
    Mass,
    /// External forces enter it.
    External,
    /// It depends on which joints are actuated.
    Actuation,
    /// It is of moving bodies alone: armature and friction do not enter it.
    BodiesAlone,
}

/// Everything that is known of a function.
pub(super) struct Definition {
    /// The name in generated code, in attributes and on the command line.
    pub(super) name: &'static str,
    /// What it computes, with the letters of the paper, by the names of frame 0 and of the frame that it
    /// is of.
    pub(super) sentence: fn(&str, &str) -> String,
    /// What it is a function of, in the order of its parameters.
    pub(super) arguments: &'static [Variable],
    /// Its result.
    pub(super) result: Outcome,
    /// What distinguishes it from others.
    pub(super) properties: &'static [Property],
    /// What every expansion is held against.
    pub(super) truth: Truth,
    /// The ways to compute it between which only the count decides.
    pub(super) ways: fn() -> Vec<Way>,
    /// What it costs by dense 4×4 matrices.
    pub(super) dense: fn(Size) -> Tally,
    /// Its results, in the order of its quantities.
    pub(super) build: for<'g> fn(&Scene<'_, 'g>) -> Vec<Term<'g>>,
}

impl Definition {
    /// No alternatives.
    pub(super) fn one_way() -> Vec<Way> {
        vec![Way::PLAIN]
    }
}
