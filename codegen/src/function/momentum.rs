//! The momentum Γ = Σ skew\[W J\] of all bodies that joints move (paper, eqs. 20 and 26).

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally, VELOCITY};
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::{Scene, momentum};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "momentum",
    sentence: |base, _| {
        format!(
            "Momentum Γ₍₀₎ of all bodies that joints move, in the axes of {base} (frame 0), reference point at its origin; kg m²/s, kg m/s."
        )
    },
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::MOMENTUM,
    properties: &[Property::Mass, Property::BodiesAlone],
    truth: Truth::Value(|dense, _| {
        dense
            .moments(MotionOrder::Coasting)
            .skew()
            .vectors()
            .to_vec()
    }),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    let link = KINEMATIC.plus(INERTIA).plus(VELOCITY);
    let link = link.plus(Tally::of(1, 0, 1));
    link.times(size.joints).plus(Tally::of(0, 0, 1))
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let all = momentum::momentum(&scene.joints(), &scene.state);
    all.entries().to_vec()
}
