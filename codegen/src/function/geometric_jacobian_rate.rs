//! The rate of the Jacobian in the axes of frame 0: columns L̇₁ … L̇_N, pole at the origin of the tip, which
//! moves.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally;
use crate::dense::{Matrix, Motion};
use crate::expression::Term;
use crate::model::{Carried, Scene, Way, jacobian_rate};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "geometric_jacobian_rate",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::SCREW_RATES,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| {
        let tip = dense.pose(frame).column();
        let (w, _) = dense.motion(frame, Motion::Coasting);
        // The pole moves by W P, and takes the axes along unturned.
        let mut pole = Matrix::zero();
        pole.set_column(w.times(&Matrix::translation(tip)).column());
        let back = Matrix::translation(tip.map(|entry| -entry));
        dense.column_rates(frame, |screw, rate| {
            back.carries(&rate.minus(&pole.commutator(screw)))
        })
    }),
    ways,
    dense: tally::screw_rates_elsewhere,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Rate of the geometric Jacobian of {frame}: L̇ of the joints in the axes of {base} (frame \
         0), pole at the moving origin of {frame}."
    )
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let rates = jacobian_rate::geometric(&scene.link_path(), &scene.state, scene.way.pose);
    scene.columns(&rates)
}

/// The pole is seen from each body, or all bodies about the pole.
fn ways() -> Vec<Way> {
    let pose = Carried::Outwards;
    vec![Way::PLAIN, Way { pose, ..Way::PLAIN }]
}
