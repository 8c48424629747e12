//! The base regressor: linearly independent columns of the regressor, one for each base parameter.

use super::definition::{Definition, Truth};
use super::{quantities, regressor};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "base_regressor",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd],
    result: quantities::BASE_REGRESSOR,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.base_regressor()),
    algorithms: Definition::one_way,
    dense: regressor::dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Base regressor Y(q, q̇, q̈) of τ = Y π, by rows, where π are the base parameters: the linear combinations \
     of inertial parameters that torques determine. Each has the column of its leading parameter."
        .to_owned()
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let all = scene.regressor();
    let columns = scene.bodies.base_columns.iter();
    scene.rows_of(&columns.map(|&column| &all[column]).collect::<Vec<_>>())
}
