//! The time derivative of the entries of the body Jacobian: columns L̇₁ … L̇_N in the moving frame of the end effector,
//! reference point at its origin.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally;
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::{Scene, jacobian_rate};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "body_jacobian_rate",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::SCREW_RATES,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| {
        let back = dense.pose(frame).inverse();
        let (w, _) = dense.motion(frame, MotionOrder::Coasting);
        dense.column_rates(frame, |screw, rate| {
            back.carries(&rate.minus(&w.commutator(screw)))
        })
    }),
    algorithms: Definition::one_way,
    dense: tally::screw_rates_elsewhere,
    build,
};

fn sentence(_: &str, frame: &str) -> String {
    format!(
        "Time derivative of the entries of the body Jacobian of {frame}: L̇ of the joints in the moving axes of \
         {frame}, reference point at its origin."
    )
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let rates = jacobian_rate::body(&scene.link_path(), &scene.state);
    scene.columns(&rates)
}
