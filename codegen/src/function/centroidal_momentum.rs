//! The momentum Γ = Σ skew\[W J\] of all bodies that joints move, about their centre of mass.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally, VELOCITY};
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::{MassCenter, Scene, momentum};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "centroidal_momentum",
    sentence: |base, _| {
        format!(
            "Momentum Γ of all bodies that joints move, about their centre of mass, in the axes of {base} (frame 0); kg m²/s, kg m/s."
        )
    },
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::MOMENTUM,
    properties: &[Property::Mass, Property::BodiesAlone],
    truth: Truth::OfMass(|dense, _| {
        let momentum = dense.moments(MotionOrder::Coasting).skew();
        dense.about_mass_center(&momentum).vectors().to_vec()
    }),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // Σ W J and Σ J, and a change of frame.
    let link = KINEMATIC.plus(INERTIA).plus(VELOCITY);
    let link = link.plus(Tally::of(1, 0, 2));
    link.times(size.joints).plus(Tally::of(2, 0, 1)).and(3, 0)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let (joints, base) = scene.seen_from_root();
    let center = MassCenter::of(&joints, &base).point();
    let all = momentum::momentum(&joints, &scene.state);
    all.about(center).entries().to_vec()
}
