//! The residuals of the loops: entries of the pose M of one frame of a loop in the other.

use super::definition::{Definition, Truth};
use super::quantities;
use super::tally::{POSE, Size, Tally};
use crate::expression::Term;
use crate::model::{Scene, loops};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "constraint",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::RESIDUALS,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.residuals()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Residuals of the loops, zero if they are closed. For frames A and B of a loop: lengths along the axes of A \
     in m, products of an axis of A and one of B; for a rod (d² − l²)/2l."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    POSE.times(size.joints).plus(Tally::of(1, 0, 0))
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    loops::residuals(scene)
}
