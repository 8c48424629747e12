//! What changes of q, q̇ and τ do to the joint accelerations that τ produces: of M q̈ + … = τ with q̈ as it is,
//! ∂q̈ = M⁻¹ (∂τ − what inverse dynamics changes by).

use super::definition::{Definition, Truth};
use super::tally::{Size, Tally};
use super::{forward_dynamics, inverse_dynamics_derivatives, mass_matrix_inverse, quantities};
use crate::expression::Term;
use crate::formulation::Forward;
use crate::model::{self, Scene};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_dynamics_derivatives",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Tau],
    result: quantities::ACCELERATION_DERIVATIVES,
    of_a_frame: false,
    truth: Truth::Derivatives,
    ways: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Derivatives ∂q̈/∂q, ∂q̈/∂q̇ and ∂q̈/∂τ = M⁻¹ of the joint accelerations that τ produces against \
     gravity, a row for each acceleration."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    // Besides q̈, M⁻¹ and the derivatives of τ two products of matrices.
    let parts = inverse_dynamics_derivatives::dense(size).plus(forward_dynamics::dense(size));
    let cubes = 3 * size.joints.pow(3);
    parts.and(cubes, cubes)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let accelerations = forward_dynamics::build(scene);
    let inverse = mass_matrix_inverse::build(scene);
    let [dq, dqd] = scene.torque_derivatives(&accelerations).map(|needed| {
        let found = match scene.way.forward {
            Forward::UNREFINED => {
                model::forward_dynamics::solved(&scene.mass_matrix(), &scene.parents(), &needed)
            }
            _ => product(&inverse, &needed, scene.velocities()),
        };
        found.into_iter().map(|entry| -entry).collect::<Vec<_>>()
    });
    [dq, dqd, inverse].concat()
}

/// A B of square matrices, row by row.
fn product<'g>(a: &[Term<'g>], b: &[Term<'g>], count: usize) -> Vec<Term<'g>> {
    let entry = |k: usize| {
        let (row, column) = (&a[k / count * count..], &b[k % count..]);
        let terms = row.iter().zip(column.iter().step_by(count)).take(count);
        let terms = terms.map(|(x, y)| *x * *y);
        terms.reduce(|sum, term| sum + term)
    };
    (0..count * count).filter_map(entry).collect()
}
