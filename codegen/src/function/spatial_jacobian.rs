//! The spatial Jacobian: columns L₁ … L_N in the axes of frame 0, reference point at its origin.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{KINEMATIC, Size, Tally};
use crate::expression::Term;
use crate::model::{Scene, jacobian};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "spatial_jacobian",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::SCREWS,
    properties: &[Property::Frame],
    truth: Truth::Value(|dense, frame| dense.columns(frame, Clone::clone)),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(base: &str, frame: &str) -> String {
    format!(
        "Spatial Jacobian of {frame}: screws L of the joints in the axes of {base} (frame 0), \
         reference point at its origin."
    )
}

fn dense(size: Size) -> Tally {
    KINEMATIC.times(size.path)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.columns(&jacobian::spatial(&scene.link_path()))
}
