//! Derivatives of inverse dynamics by q and q̇. The derivative by q̈ is the mass matrix.

use super::definition::{Definition, Property, Truth};
use super::tally::{Size, Tally};
use super::{mass_matrix, quantities, tally};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "inverse_dynamics_derivatives",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd],
    result: quantities::FORCE_DERIVATIVES,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Value(|dense, _| dense.torque_derivatives().map(Vec::from).concat()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Derivatives ∂τ/∂q and ∂τ/∂q̇ of the joint torques and forces that produce q̈ against gravity, a \
     row for each force; N m, N, N/m and N m s, N s, N s/m."
        .to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    // Two matrices, whose entries cost as much as two of M each.
    let parts = mass_matrix::dense(size).times(4);
    parts.plus(tally::torques(size))
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let derivatives = scene.torque_derivatives(&scene.qdd());
    derivatives.map(Vec::from).concat()
}
