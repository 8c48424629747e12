//! Second derivatives of forward dynamics, contracted with weights: the Hessian of λᵀq̈ by q, q̇ and τ.
//!
//! With y = M⁻¹ λ and B for the blocks of the Hessian of yᵀτ at constant q̈, a second derivative of τ(q, q̇, q̈(q, q̇, τ))
//! gives, with D = −B_qq̈ M⁻¹,
//!
//! * by q and τ: D,
//! * by q and q̇: −B_qq̇ − D ∂τ/∂q̇,
//! * by q and q: −B_qq − D ∂τ/∂q − (D ∂τ/∂q)ᵗ,
//! * by q̇ and q̇: −B_q̇q̇,
//!
//! and all others are zero. No derivative of q̈ is needed.

use super::definition::{Definition, Given, Property, Truth};
use super::tally::{Size, Tally};
use super::{forward_dynamics, inverse_dynamics_hessian, mass_matrix_inverse, quantities};
use crate::expression::Term;
use crate::list::{List, Square};
use crate::model::{self, FreeFall, Scene};
use crate::space::{Variable, VelocityId};

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_dynamics_hessian",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Tau, Variable::Weights],
    result: quantities::ACCELERATION_HESSIAN,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Solution(Given::Hessian),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Second derivatives of λᵀq̈ by q, q̇ and τ, for weights λ, in N m or N, of the joint accelerations \
     that τ produces against gravity."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    let parts = inverse_dynamics_hessian::dense(size).plus(forward_dynamics::dense(size));
    let cubes = 4 * size.joints.pow(3);
    parts.and(cubes, cubes)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let falling = FreeFall::of(scene);
    let scene = falling.scene();
    let accelerations = forward_dynamics::accelerations(scene);
    let moved = forward_dynamics::of_weights(scene);
    let [q_q, q_qd, qd_qd, q_qdd] = falling.torque_hessian([&accelerations, &moved]);
    let [by_q, by_qd] = falling.torque_derivatives(&accelerations);
    let rows = q_qdd.rows().map(|row| row.map(|&entry| -entry));
    // M⁻¹ is symmetric: its products with the rows are the rows of D.
    let rows = mass_matrix_inverse::times(scene, &rows.collect::<Vec<_>>());
    let [turned, slowed] = [by_q, by_qd].map(|by| opposite_product(&rows, &by));
    let by_tau = of_rows(rows);
    let places: Vec<(VelocityId, VelocityId)> = q_q.places().collect();
    let [by_orientation, by_motion] = falling.hessian(&scene.weights());
    let q_q = places.iter().map(|&(row, column)| {
        let both = turned[(row, column)] + turned[(column, row)];
        by_orientation[(row, column)] - (q_q[(row, column)] - both)
    });
    let q_qd = places.iter().map(|&place| -(q_qd[place] - slowed[place]));
    let qd_qd = places.iter().map(|&place| by_motion[place] - qd_qd[place]);
    q_q.chain(q_qd)
        .chain(qd_qd)
        .chain(Vec::from(by_tau))
        .collect()
}

/// The product −A B, of the rows of A. Results need it with this sign, which is free if all rows are computed with it.
fn opposite_product<'g>(
    rows: &[List<VelocityId, Term<'g>>],
    b: &Square<VelocityId, Term<'g>>,
) -> Square<VelocityId, Term<'g>> {
    let transposed = Square::of_columns(&b.rows().collect());
    let operations = rows.len().pow(2);
    let rows = model::alike(rows, operations, |row| {
        let product = mass_matrix_inverse::product(&transposed, row);
        product.map(|&entry| -entry)
    });
    of_rows(rows)
}

fn of_rows(rows: Vec<List<VelocityId, Term<'_>>>) -> Square<VelocityId, Term<'_>> {
    Square::of_rows(&rows.into_iter().flatten().collect::<Vec<_>>())
}
