//! H₀,tip₍₀₎ at q̈ = 0: the velocity-dependent part of the acceleration matrix of a frame, without gravity.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{MOVING, Size, Tally};
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::{Algorithm, Carried, Scene};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "acceleration_bias",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::ACCELERATION,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| dense.motion(frame, MotionOrder::Coasting).1.upper()),
    algorithms,
    dense,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Acceleration matrix H₀,ₜ₍₀₎ of {frame} at q̈ = 0 in the axes of {base} (frame 0), reference point at \
         its origin, without gravity; 1/s², m/s²."
    )
}

fn dense(size: Size) -> Tally {
    MOVING.times(size.path)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.acceleration(|_| scene.state.zero())
}

/// From the end effector inwards, which costs less alone; from the base outwards, which shares work with dynamics.
fn algorithms() -> Vec<Algorithm> {
    let pose = Carried::Outwards;
    vec![
        Algorithm::PLAIN,
        Algorithm {
            pose,
            ..Algorithm::PLAIN
        },
    ]
}
