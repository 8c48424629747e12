//! The time derivative of the geometric Jacobian: columns L̇₁ … L̇_N in the axes of frame 0, reference point at the
//! moving origin of the end effector.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally;
use crate::dense::Dense;
use crate::expression::Term;
use crate::model::{Algorithm, Carried, Scene, jacobian_rate};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "geometric_jacobian_rate",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::SCREW_RATES,
    properties: &[Property::Frame],
    truth: Truth::Value(Dense::geometric_rates),
    algorithms,
    dense: tally::screw_rates_elsewhere,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Time derivative of the geometric Jacobian of {frame}: L̇ of the joints in the axes of {base} \
         (frame 0), reference point at the moving origin of {frame}."
    )
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let rates = jacobian_rate::geometric(&scene.link_path(), &scene.state, scene.algorithm.pose);
    scene.columns(&rates)
}

/// The reference point is transformed to each body, or each body to the reference point.
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
