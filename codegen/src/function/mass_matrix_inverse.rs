//! The inverse of the joint-space inertia matrix.

use super::definition::{Definition, Given, Property, Truth};
use super::mass_matrix;
use super::quantities;
use super::tally::{Size, Tally};
use crate::expression::Term;
use crate::formulation::Forward;
use crate::list::{List, Square};
use crate::model::{self, Scene, articulated, forward_dynamics};
use crate::space::{Variable, VelocityId};

pub(super) const DEFINITION: Definition = Definition {
    name: "mass_matrix_inverse",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::INVERSE_INERTIAS,
    properties: &[Property::Mass],
    truth: Truth::Solution(Given::MassMatrix),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Inverse of the joint-space inertia matrix M(q), by rows; 1/(kg m²), 1/(kg m), 1/kg.".to_owned()
}

fn dense(size: Size) -> Tally {
    let cubes = size.joints.pow(3);
    mass_matrix::dense(size).and(cubes, cubes)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    inverse(scene).into()
}

/// M⁻¹ by the mass matrix or by articulated bodies.
pub(super) fn inverse<'g>(scene: &Scene<'_, 'g>) -> Square<VelocityId, Term<'g>> {
    match scene.algorithm.forward {
        Forward::MassMatrix { refinements } => forward_dynamics::mass_matrix_inverse(
            &scene.mass_matrix(),
            &scene.parents(),
            |qdd| scene.inertial(qdd),
            refinements,
        ),
        Forward::Articulated => {
            articulated::mass_matrix_inverse(&scene.link_joints(), &scene.state).renumbered()
        }
    }
}

/// M⁻¹ times some columns.
pub(super) fn times<'g>(
    scene: &Scene<'_, 'g>,
    columns: &[List<VelocityId, Term<'g>>],
) -> Vec<List<VelocityId, Term<'g>>> {
    if scene.algorithm.forward == Forward::UNREFINED {
        return forward_dynamics::solved(&scene.mass_matrix(), &scene.parents(), columns);
    }
    // All rows of the inverse have the same zeros, so that one loop computes all rows of the product; columns of
    // branches have different ones.
    let inverse: Vec<List<VelocityId, Term<'g>>> = inverse(scene).rows().collect();
    let entries = columns.iter().flatten();
    let operations = entries.filter(|entry| !entry.is_zero()).count();
    let rows = model::alike(&inverse, operations, |row| -> Vec<Term<'g>> {
        columns.iter().map(|column| dot(row, column)).collect()
    });
    let column = |k: usize| rows.iter().map(|row| row[k]).collect();
    (0..columns.len()).map(column).collect()
}

/// The product A b.
pub(super) fn product<'g>(
    a: &Square<VelocityId, Term<'g>>,
    b: &List<VelocityId, Term<'g>>,
) -> List<VelocityId, Term<'g>> {
    a.rows().map(|row| dot(&row, b)).collect()
}

fn dot<'g>(a: &List<VelocityId, Term<'g>>, b: &List<VelocityId, Term<'g>>) -> Term<'g> {
    let terms = a.iter().zip(b).map(|(&a, &b)| a * b);
    let sum = terms.reduce(|sum, term| sum + term);
    sum.expect("as many terms as joints")
}
