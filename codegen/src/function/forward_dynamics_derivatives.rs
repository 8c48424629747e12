//! Derivatives of forward dynamics by q, q̇ and τ: ∂q̈ = M⁻¹ (∂τ − ∂ID), with ∂ID the derivative of inverse dynamics at
//! constant q̈.

use super::definition::{Definition, Given, Property, Truth};
use super::tally::{Size, Tally};
use super::{forward_dynamics, inverse_dynamics_derivatives, mass_matrix_inverse, quantities};
use crate::expression::Term;
use crate::list::{Id, List};
use crate::model::{FreeFall, Scene};
use crate::space::{Variable, VelocityId};

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_dynamics_derivatives",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Tau],
    result: quantities::ACCELERATION_DERIVATIVES,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Solution(Given::TorqueDerivatives),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Derivatives ∂q̈/∂q, ∂q̈/∂q̇ and ∂q̈/∂τ = M⁻¹ of the joint accelerations that τ produces against \
     gravity, a row for each acceleration."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    // q̈, M⁻¹, the derivatives of τ, and two products of matrices.
    let parts = inverse_dynamics_derivatives::dense(size).plus(forward_dynamics::dense(size));
    let cubes = 3 * size.joints.pow(3);
    parts.and(cubes, cubes)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let falling = FreeFall::of(scene);
    let scene = falling.scene();
    let accelerations = forward_dynamics::accelerations(scene);
    let inverse = mass_matrix_inverse::inverse(scene);
    let changes = falling.torque_derivatives(&accelerations);
    let columns = changes.iter().flat_map(|change| {
        let columns = change.ids().map(|column| change.column(column));
        columns.map(|column| column.map(|&entry| -entry))
    });
    let columns: Vec<List<VelocityId, Term<'g>>> = columns.collect();
    let found = mass_matrix_inverse::times(scene, &columns);
    let changes = found.chunks(inverse.ids().len()).zip(falling.derivatives());
    let by_rows = changes.flat_map(|(columns, fall)| {
        let places = inverse.places();
        let entries =
            places.map(|(row, column)| columns[column.index()][row] + fall[(row, column)]);
        entries.collect::<Vec<_>>()
    });
    by_rows.chain(Vec::from(inverse.clone())).collect()
}
