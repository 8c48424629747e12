//! Second time derivatives of the residuals of the loops at q̈ = 0: entries of H M.

use super::definition::{Definition, Truth};
use super::quantities;
use super::tally::{MOVING, Size, Tally};
use crate::expression::Term;
use crate::model::{Scene, loops};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "constraint_bias",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::RESIDUAL_ACCELERATIONS,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.residual_bias()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Second time derivatives J̇ q̇ of the residuals of the loops at q̈ = 0, with their Jacobian J; 1/s², m/s²."
        .to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    MOVING.times(size.joints).plus(Tally::of(3, 0, 2))
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    loops::bias(scene)
}
