//! Joint accelerations that forces and torques produce.

use super::dense::{self, Size, Tally};
use super::table::Definition;
use super::{Argument, Shape, mass_matrix, units};
use crate::expression::Term;
use crate::formulation::Forward;
use crate::model::{Scene, articulated, forward_dynamics};

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_dynamics",
    sentence,
    arguments: &[Argument::Q, Argument::Qd, Argument::Tau],
    shape: Shape::Vector,
    units: units::accelerations,
    solves: true,
    ways: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint accelerations q̈ that τ produces against gravity; rad/s², m/s².".to_owned()
}

fn dense(size: Size) -> Tally {
    // M, the bias, a dense factorisation and one solve.
    let (cubes, squares) = (size.joints.pow(3) / 6, size.joints.pow(2));
    let parts = mass_matrix::dense(size).plus(dense::torques(size));
    parts.and(cubes + squares, cubes + squares)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    match scene.way.forward {
        Forward::MassMatrix { refinements } => forward_dynamics::forward_dynamics(
            &scene.mass_matrix(),
            &scene.parents(),
            |k| scene.state.tau(k),
            |qdd| scene.torques(qdd),
            refinements,
        ),
        Forward::Articulated => {
            articulated::forward_dynamics(&scene.joints(), scene.bodies.gravity, &scene.state)
        }
    }
}
