//! H₀,tip₍₀₎: the acceleration matrix of a frame, without gravity.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{MOVING, Size, Tally};
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "acceleration",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd],
    result: quantities::ACCELERATION,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| dense.motion(frame, MotionOrder::Accelerated).1.upper()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Acceleration matrix H₀,ₜ₍₀₎ of {frame} in the axes of {base} (frame 0), reference point at its \
         origin, without gravity; 1/s², m/s²."
    )
}

fn dense(size: Size) -> Tally {
    MOVING.times(size.path)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.acceleration(|k| scene.state.qdd(k))
}
