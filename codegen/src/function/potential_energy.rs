//! The potential energy −Σ Tr(H_g J) (paper, § 4.5) of all bodies that joints move, zero at the origin of
//! frame 0, by composite first moments.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally};
use crate::dense::{Approximate, MotionOrder};
use crate::expression::{Block, LabelledBodies, Term};
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "potential_energy",
    sentence: |base, _| {
        format!("Potential energy of gravity, zero at the origin of {base} (frame 0); J.")
    },
    arguments: &[Variable::Q],
    result: quantities::ENERGY,
    properties: &[Property::Mass],
    truth: Truth::Value(|dense, _| {
        let gravity = dense.gravity();
        let energies = (dense.links(MotionOrder::Rest)).map(|(_, j)| gravity.times(j).trace());
        let energy = energies.fold(Approximate::exact(0.0), |sum, energy| sum - energy);
        vec![energy]
    }),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    let link = KINEMATIC.plus(INERTIA).plus(Tally::default().and(16, 16));
    link.times(size.joints)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let joints = scene.joints();
    let mut masses = joints.map(|joint| joint.inertia.mass);
    let mut moments = joints.map(|joint| joint.inertia.q);
    // Regrouping has moved first moments to the base.
    let mut moment = scene.bodies.base.q;
    for (k, joint) in joints.numbered().rev() {
        let (q, mass) = (moments[k], masses[k]);
        let (index, frame) = joint.numbers();
        q.label(
            Block::Inertia
                .of(LabelledBodies::Body(index))
                .seen_in(frame),
        );
        let carried = joint.first_moment_inboard(q, mass);
        if let Some(parent) = joint.parent {
            moments[parent] = moments[parent] + carried;
            masses[parent] = masses[parent] + mass;
        } else {
            moment = moment + carried;
        }
    }
    vec![-scene.gravity.dot(moment)]
}
