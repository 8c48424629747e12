//! W₀,tip₍₀₎: the velocity matrix of a frame.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{KINEMATIC, Size, Tally, VELOCITY};
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::{Scene, twist};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "velocity",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::VELOCITY,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| {
        dense
            .motion(frame, MotionOrder::Coasting)
            .0
            .vectors()
            .to_vec()
    }),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Velocity matrix W₀,ₜ₍₀₎ of {frame} in the axes of {base} (frame 0), reference point \
         at its origin; rad/s, m/s."
    )
}

fn dense(size: Size) -> Tally {
    KINEMATIC.plus(VELOCITY).times(size.path)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    twist::velocity(&scene.path(), &scene.state)
}
