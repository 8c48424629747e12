//! The rate of change of the centroidal momentum at q̈ = 0: Ȧ q̇ = Σ skew\[H J\], with A the centroidal momentum matrix.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, MOVING, Size, Tally};
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::{MassCenter, Scene, momentum};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "centroidal_momentum_bias",
    sentence: |base, _| {
        format!(
            "Rate of change Ȧ q̇ of the centroidal momentum at q̈ = 0, with the centroidal momentum matrix A of all bodies that joints move, in the axes of {base} (frame 0); N m, N."
        )
    },
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::ACTION,
    properties: &[Property::Mass, Property::BodiesAlone],
    truth: Truth::OfMass(|dense, _| {
        let rate = dense.inertia_forces(MotionOrder::Coasting).skew();
        dense.about_mass_center(&rate).vectors().to_vec()
    }),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // Σ H J and Σ J, and a change of frame.
    let link = MOVING.plus(INERTIA).plus(Tally::of(1, 0, 2));
    link.times(size.joints).plus(Tally::of(2, 0, 1)).and(3, 0)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let (joints, base) = scene.seen_from_root();
    let center = MassCenter::of(&joints, &base).point();
    let all = momentum::bias(&joints, &scene.state);
    all.about(center).entries().to_vec()
}
