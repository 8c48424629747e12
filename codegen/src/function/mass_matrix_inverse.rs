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
    let inverse = inverse(scene);
    let operations = inverse.ids().len().pow(2);
    model::alike(columns, operations, |column| product(&inverse, column))
}

/// The product A b.
pub(super) fn product<'g>(
    a: &Square<VelocityId, Term<'g>>,
    b: &List<VelocityId, Term<'g>>,
) -> List<VelocityId, Term<'g>> {
    let rows = a.ids().map(|row| {
        let terms = a.row(row).zip(b).map(|(a, &b)| a * b);
        let entry = terms.reduce(|sum, term| sum + term);
        entry.expect("as many terms as rows")
    });
    rows.collect()
}
