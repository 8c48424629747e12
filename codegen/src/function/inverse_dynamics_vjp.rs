//! Vector–Jacobian product of inverse dynamics: the gradient of λᵀτ by q, q̇ and q̈.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{self, Size, Tally};
use crate::dense::Dense;
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "inverse_dynamics_vjp",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd, Variable::Weights],
    result: quantities::WORK_GRADIENT,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Value(|dense, _| Dense::torque_gradient(dense)),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Vector–Jacobian product of inverse dynamics: (∂τ/∂q)ᵀ λ, (∂τ/∂q̇)ᵀ λ and (∂τ/∂q̈)ᵀ λ = M λ, for \
     weights λ, in rad or m, of the joint torques and forces that produce q̈ against gravity."
        .to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    // Λ and the sums with it cost as much as H and Φ, and the rates of each screw as much as two.
    tally::torques(size).times(4)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let parts = scene.torque_gradient([&scene.qdd(), &scene.weights()]);
    parts.map(Vec::from).concat()
}
