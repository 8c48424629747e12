//! Inverse dynamics of the actuated joints of a robot with loops, which move the other joints.

use super::definition::{Definition, Property, Truth};
use super::tally::{self, Size, Tally};
use super::{constraint_jacobian, quantities};
use crate::dense::Dense;
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "actuated_inverse_dynamics",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd],
    result: quantities::FORCES,
    properties: &[Property::Mass, Property::Actuation],
    truth: Truth::Constrained(Dense::actuated),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Torques and forces τ of the actuated joints, zero for all others, that produce q̈ against gravity; q, q̇ \
     and q̈ must keep the loops closed; N m, N. The forces of the loops move the other joints, as far as they can \
     (least squares)."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    // Inverse dynamics without loops, the Jacobian, and at most as many equations as joints.
    let cubes = size.joints.pow(3);
    let parts = tally::torques(size).plus(constraint_jacobian::dense(size));
    parts.and(cubes, cubes)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.actuated().into()
}
