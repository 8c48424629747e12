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
            articulated::forward_dynamics(&joints, gravity, &scene.state, Variable::Tau, &external)
                .renumbered()
        }
    }
}

/// M⁻¹ λ: the accelerations that λ produces as torques and forces, at rest and without gravity.
pub(super) fn of_weights<'g>(scene: &Scene<'_, 'g>) -> List<VelocityId, Term<'g>> {
    match scene.algorithm.forward {
        Forward::MassMatrix { refinements } => forward_dynamics::forward_dynamics(
            &scene.mass_matrix(),
            &scene.parents(),
            |k| scene.state.of_velocity(Variable::Weights, k),
            |qdd| scene.inertial(qdd),
            refinements,
        ),
        Forward::Articulated => {
            let (joints, nothing) = (
                scene.link_joints(),
                Vector::zero(scene.state.zero().graph()),
            );
            let rest = scene.state.at_rest();
            articulated::forward_dynamics(&joints, nothing, &rest, Variable::Weights, &[])
                .renumbered()
        }
    }
}
