//! Jacobian–vector product of forward dynamics: q̈, and its change along changes of q, q̇ and τ. By the equation of
//! motion M δq̈ = δτ − δID, with δID the change of inverse dynamics at constant q̈.

use super::definition::{Definition, Given, Property, Truth};
use super::tally::{Size, Tally};
use super::{forward_dynamics, inverse_dynamics_jvp, quantities};
use crate::expression::Term;
use crate::list::List;
use crate::model::{FreeFall, Scene, change};
use crate::space::{Variable, VelocityId};

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_dynamics_jvp",
    sentence,
    arguments: &[
        Variable::Q,
        Variable::Qd,
        Variable::Tau,
        Variable::QChange,
        Variable::QdChange,
        Variable::TauChange,
    ],
    result: quantities::ACCELERATION_CHANGE,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Solution(Given::Change),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Jacobian–vector product of forward dynamics: the joint accelerations q̈ that τ produces against gravity, and their \
     change (∂q̈/∂q) δq + (∂q̈/∂q̇) δq̇ + M⁻¹ δτ."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    let squares = size.joints.pow(2);
    let parts = forward_dynamics::dense(size).plus(inverse_dynamics_jvp::dense(size));
    parts.and(squares, squares)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let falling = FreeFall::of(scene);
    let scene = falling.scene();
    let relative = forward_dynamics::accelerations(scene);
    let by_motion = change::at_constant_accelerations(scene, &relative);
    let changes = scene.entries(Variable::TauChange);
    let forces = changes
        .iter()
        .zip(by_motion)
        .map(|(&all, by_motion)| all - by_motion);
    let forces: List<VelocityId, _> = forces.collect();
    let relative_change = forward_dynamics::by_forces(scene, |k| forces[k]);
    let change = relative_change
        .iter()
        .zip(falling.change())
        .map(|(&a, fall)| a + fall);
    let accelerations = falling.accelerations(&relative);
    accelerations.into_iter().chain(change).collect()
}
