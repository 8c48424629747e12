//! The kinetic energy ½ Σ Tr(W J Wᵗ) (paper, eq. 22), in the frames of the links, and that of the armatures.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally, VELOCITY};
use crate::chain::BodyId;
use crate::dense::{Approximate, MotionOrder};
use crate::expression::Term;
use crate::list::List;
use crate::matrix::{Action, Screw, Velocity};
use crate::model::{Scene, moving};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "kinetic_energy",
    sentence: |_, _| "Kinetic energy ½ q̇ᵗ M(q) q̇; J.".to_owned(),
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::ENERGY,
    properties: &[Property::Mass],
    truth: Truth::Value(|dense, _| {
        let twice = (dense.links(MotionOrder::Coasting))
            .map(|(w, j)| w.times(j).times(&w.transposed()).trace())
            .fold(dense.twice_energy_of_actuators(), |sum, energy| {
                sum + energy
            });
        vec![twice * Approximate::exact(0.5)]
    }),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // W J, and the trace of its product with Wᵗ alone.
    let energy = Tally::of(1, 0, 0).and(16, 16);
    let link = KINEMATIC.plus(INERTIA).plus(VELOCITY).plus(energy);
    link.times(size.joints).and(1, 0)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let zero = scene.state.zero();
    let mut velocities: List<BodyId, Velocity<Term<'g>>> = List::new();
    let mut twice = zero;
    for joint in scene.joints() {
        let at_rest = Velocity::zero(zero.graph());
        let outer = joint.parent.map_or(at_rest, |parent| velocities[parent]);
        let rate = scene.state.qd(joint.body);
        let w = moving::beyond(outer, &joint, rate);
        // Tr(W J Wᵗ) = W ⊗ skew[W J].
        let twist = Screw { u: w.omega, b: w.v };
        twice = twice + Action::of_screw(twist, joint.inertia).along(twist);
        twice = twice + joint.actuator.armature * rate * rate;
        velocities.push(w);
    }
    vec![twice * scene.state.constant(0.5)]
}
