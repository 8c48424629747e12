//! Definition of a function: a value of this type is in the file of each function.

use super::tally::{Size, Tally};
use crate::dense::{Approximate, Dense};
use crate::expression::Term;
use crate::list::List;
use crate::model::{Algorithm, Scene};
use crate::space::{FrameId, Outcome, Variable, VelocityId};

/// Reference for the results of a function, independent of the algorithm.
#[derive(Clone, Copy)]
pub(crate) enum Truth {
    /// Value by dense matrices, at a state and for a frame.
    Value(fn(&Dense, FrameId) -> Vec<Approximate>),
    /// The same, defined only for robots with mass.
    OfMass(fn(&Dense, FrameId) -> Vec<Approximate>),
    /// Solution of the dynamics of loops by dense matrices; the number is the relative pivot below which a
    /// residual counts as dependent.
    Constrained(fn(&Dense, f64) -> Vec<Approximate>),
    /// The parts of the result, matrices over velocities, each multiplied from the left by a direction: fewer
    /// values than the result has.
    Directional(fn(&Dense, &List<VelocityId, Approximate>) -> Vec<Approximate>),
    /// Equation that the results solve, with these given data.
    Solution(Given),
}

/// Given data of an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// τ; the solution is q̈.
    Torques,
    /// M; the solution is each column of M⁻¹ from its diagonal entry on, each for a different perturbed M.
    MassMatrix,
    /// ∂τ/∂q and ∂τ/∂q̇ at the q̈ that τ produces; the solution is each column of ∂q̈/∂q and ∂q̈/∂q̇.
    TorqueDerivatives,
    /// Y at the q̈ that τ produces; the solution is each column of −M⁻¹ Y.
    Regressor,
    /// λ; the solution is M⁻¹ λ, by which the derivatives of τ are weighted.
    Gradient,
    /// δτ less the change of torques at constant q̈; the solutions are q̈ and its change.
    Change,
    /// λ and ∂(M y)/∂q with y = M⁻¹ λ; the solution is y, and M⁻¹ times each row of the latter.
    Hessian,
}

/// Property of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Property {
    /// Belongs to a frame, of the end effector or another link, and not to the whole robot.
    Frame,
    /// Masses and inertias are part of its expressions; false for regressors, whose columns they multiply.
    Mass,
    /// External wrenches enter it.
    External,
    /// Depends on which joints are actuated.
    Actuation,
    /// Excludes armature and friction of joints.
    BodiesAlone,
}

/// Definition of a function.
pub(super) struct Definition {
    /// Name in generated code, in attributes and on the command line.
    pub(super) name: &'static str,
    /// Sentence about its result, with the letters of the paper; the arguments are the names of frame 0 and of the
    /// function's frame.
    pub(super) sentence: fn(&str, &str) -> String,
    /// Arguments in the order of parameters, without external wrenches.
    pub(super) arguments: &'static [Variable],
    /// Result.
    pub(super) result: Outcome,
    /// Properties.
    pub(super) properties: &'static [Property],
    /// Reference for the check.
    pub(super) truth: Truth,
    /// Equivalent algorithms, among which the one with the fewest operations is chosen.
    pub(super) algorithms: fn() -> Vec<Algorithm>,
    /// Cost by dense 4×4 matrices.
    pub(super) dense: fn(Size) -> Tally,
    /// Expressions of its results, in the order of its quantities.
    pub(super) build: for<'g> fn(&Scene<'_, 'g>) -> Vec<Term<'g>>,
}

impl Definition {
    /// A single algorithm.
    pub(super) fn one_way() -> Vec<Algorithm> {
        vec![Algorithm::PLAIN]
    }
}
