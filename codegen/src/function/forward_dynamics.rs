//! Forward dynamics: joint accelerations that torques and forces produce.

use super::definition::{Definition, Given, Property, Truth};
use super::tally::{self, Size, Tally};
use super::{mass_matrix, quantities};
use crate::expression::Term;
use crate::formulation::Forward;
use crate::list::List;
use crate::matrix::Vector;
use crate::model::{Frame, FreeFall, Scene, articulated, forward_dynamics};
use crate::space::{Variable, VelocityId};

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_dynamics",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Tau],
    result: quantities::SECOND_RATES,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Solution(Given::Torques),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint accelerations q̈ that τ produces against gravity; rad/s², m/s².".to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    // M, the bias, a dense factorisation and one solve.
    let (cubes, squares) = (size.joints.pow(3) / 6, size.joints.pow(2));
    let parts = mass_matrix::dense(size).plus(tally::torques(size));
    parts.and(cubes + squares, cubes + squares)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let falling = FreeFall::of(scene);
    let relative = accelerations(falling.scene());
    falling.accelerations(&relative).into()
}

/// q̈ by the mass matrix or by articulated bodies.
pub(super) fn accelerations<'g>(scene: &Scene<'_, 'g>) -> List<VelocityId, Term<'g>> {
    match scene.algorithm.forward {
        Forward::MassMatrix { refinements } => forward_dynamics::forward_dynamics(
            &scene.mass_matrix(),
            &scene.parents(),
            |k| scene.state.of_velocity(Variable::Tau, k),
            |qdd| scene.driving(qdd),
            refinements,
        ),
        Forward::Articulated => {
            let (joints, external) = (scene.link_joints(), scene.external(Frame::Link));
            let gravity = scene.gravity;
            let tau = |k| scene.state.own(Variable::Tau, k);
            articulated::forward_dynamics(&joints, gravity, &scene.state, tau, &external)
                .renumbered()
        }
    }
}

/// M⁻¹ λ.
pub(super) fn of_weights<'g>(scene: &Scene<'_, 'g>) -> List<VelocityId, Term<'g>> {
    by_forces(scene, |k| scene.state.of_velocity(Variable::Weights, k))
}

/// The accelerations that torques and forces produce at rest and without gravity: the product with M⁻¹. They are read
/// only when they are needed, because older terms come first in a sum.
pub(super) fn by_forces<'g>(
    scene: &Scene<'_, 'g>,
    forces: impl Fn(VelocityId) -> Term<'g>,
) -> List<VelocityId, Term<'g>> {
    match scene.algorithm.forward {
        Forward::MassMatrix { refinements } => forward_dynamics::forward_dynamics(
            &scene.mass_matrix(),
            &scene.parents(),
            forces,
            |qdd| scene.inertial(qdd),
            refinements,
        ),
        Forward::Articulated => {
            let (joints, nothing) = (
                scene.link_joints(),
                Vector::zero(scene.state.zero().graph()),
            );
            let rest = scene.state.at_rest();
            let forces = |k| rest.times_factor(k, forces(rest.velocity(k)));
            articulated::forward_dynamics(&joints, nothing, &rest, forces, &[]).renumbered()
        }
    }
}
