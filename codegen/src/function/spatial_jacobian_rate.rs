//! The time derivative of the spatial Jacobian: columns L̇₁ … L̇_N in the axes of frame 0, reference point at its origin.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{KINEMATIC, SCREW_RATE, Size, Tally, VELOCITY};
use crate::expression::Term;
use crate::model::{Scene, jacobian_rate};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "spatial_jacobian_rate",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::SCREW_RATES,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| dense.column_rates(frame, |_, rate| rate.clone())),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Time derivative of the spatial Jacobian of {frame}: L̇ of the joints in the axes of {base} \
         (frame 0), reference point at its origin."
    )
}

fn dense(size: Size) -> Tally {
    let column = KINEMATIC.plus(VELOCITY).plus(SCREW_RATE);
    column.times(size.path)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let rates = jacobian_rate::spatial(&scene.link_path(), &scene.state);
    scene.columns(&rates)
}
