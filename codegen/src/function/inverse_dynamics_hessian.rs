//! Second derivatives of inverse dynamics, contracted with weights: the Hessian of λᵀτ by q, q̇ and q̈.

use super::definition::{Definition, Property, Truth};
use super::tally::{Size, Tally};
use super::{inverse_dynamics_derivatives, quantities};
use crate::dense::Dense;
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "inverse_dynamics_hessian",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd, Variable::Weights],
    result: quantities::WORK_HESSIAN,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Directional(Dense::torque_hessian),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Second derivatives of λᵀτ by q, q̇ and q̈, for weights λ, in rad or m, of the joint torques and \
     forces that produce q̈ against gravity."
        .to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    inverse_dynamics_derivatives::dense(size).times(2)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let blocks = scene.torque_hessian([&scene.qdd(), &scene.weights()]);
    blocks.map(Vec::from).concat()
}
