//! The Jacobian of the residuals of the loops: entries of L M for each joint.

use super::definition::{Definition, Truth};
use super::quantities;
use super::tally::{KINEMATIC, SCREW, Size, Tally};
use crate::expression::Term;
use crate::model::{Scene, loops};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "constraint_jacobian",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::RESIDUAL_RATES,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.residual_rates().into_iter().flatten().collect()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Jacobian of the residuals of the loops, a row for each of them and a column for each velocity; \
     1, m, 1/m."
        .to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    KINEMATIC
        .plus(SCREW)
        .plus(Tally::of(1, 0, 0))
        .times(size.joints)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    loops::jacobian(scene).into_iter().flatten().collect()
}
