//! Jacobian–vector product of inverse dynamics: τ, and its change along changes of q, q̇ and q̈.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{self, Size, Tally};
use crate::expression::Term;
use crate::model::{Scene, change};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "inverse_dynamics_jvp",
    sentence,
    arguments: &[
        Variable::Q,
        Variable::Qd,
        Variable::Qdd,
        Variable::QChange,
        Variable::QdChange,
        Variable::QddChange,
    ],
    result: quantities::FORCE_CHANGE,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Value(|dense, _| dense.torque_change()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Jacobian–vector product of inverse dynamics: the joint torques and forces τ that produce q̈ against gravity, and \
     their change (∂τ/∂q) δq + (∂τ/∂q̇) δq̇ + M δq̈."
        .to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    // A product has two changes, each of which costs as much as the product.
    tally::torques(size).times(3)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let torques = scene.driving(&scene.qdd());
    let change = change::of(scene, &torques);
    [torques, change].map(Vec::from).concat()
}
