//! The velocity of the centre of mass of all bodies that joints move. The last column of Σ W J has the linear momentum.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally, VELOCITY};
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::{MassCenter, Scene};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "center_of_mass_velocity",
    sentence: |base, _| {
        format!(
            "Velocity of the centre of mass of all bodies that joints move, in the axes of {base} (frame 0); m/s."
        )
    },
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::POINT_RATE,
    properties: &[Property::Mass],
    truth: Truth::OfMass(|dense, _| {
        let momentum = dense.moments(MotionOrder::Coasting).column();
        dense.by_mass(momentum).to_vec()
    }),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // The sum of all W J, and three divisions by a sum of masses.
    let link = KINEMATIC.plus(INERTIA).plus(VELOCITY);
    let link = link.plus(Tally::of(1, 0, 1)).and(0, 1);
    link.times(size.joints).and(3, 0)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let joints = scene.joints();
    let center = MassCenter::of(&joints, &scene.bodies.base);
    center.velocity(&scene.state).0.to_vec()
}
