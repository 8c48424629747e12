//! The Jacobian of the centre of mass of all bodies that joints move: the last column of Σ L J over the bodies that each
//! joint carries, divided by the mass.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally};
use crate::expression::Term;
use crate::model::{Algorithm, Carried, MassCenter, Scene};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "center_of_mass_jacobian",
    sentence: |base, _| {
        format!(
            "Jacobian of the centre of mass of all bodies that joints move: its velocity at unit velocity of each degree of freedom, in the axes of {base} (frame 0)."
        )
    },
    arguments: &[Variable::Q],
    result: quantities::POINT_RATES,
    properties: &[Property::Mass],
    truth: Truth::OfMass(|dense, _| {
        let momenta = dense.unit_moments().map(|moments| moments.column());
        momenta
            .flat_map(|momentum| dense.by_mass(momentum))
            .collect()
    }),
    algorithms,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // For each column a composite J, L J, and three divisions.
    let column = KINEMATIC.plus(INERTIA).plus(Tally::of(1, 0, 1)).and(3, 0);
    column.times(size.joints)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let joints = scene.joints();
    let center = MassCenter::of(&joints, &scene.bodies.base);
    scene.gathered(&center.columns(scene.algorithm.pose).map(|column| column.0))
}

/// Each column is transformed joint by joint, or rotated by the pose of its body.
fn algorithms() -> Vec<Algorithm> {
    let pose = Carried::Outwards;
    vec![
        Algorithm::PLAIN,
        Algorithm {
            pose,
            ..Algorithm::PLAIN
        },
    ]
}
