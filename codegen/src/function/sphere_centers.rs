//! The centres of the collision spheres.

use super::definition::{Definition, Truth};
use super::tally::{POSE, Size, Tally};
use super::{forward_kinematics, quantities};
use crate::model::spheres;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "sphere_centers",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::CENTERS,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.sphere_centers()),
    algorithms: forward_kinematics::algorithms,
    dense,
    build: spheres::centers,
};

fn sentence(base: &str, _: &str) -> String {
    format!("Centres of the collision spheres in the frame of {base} (frame 0), in m.")
}

pub(super) fn dense(size: Size) -> Tally {
    // Each joint moves the spheres beyond it, each of which is fixed to a body.
    POSE.times(size.joints).plus(Tally::of(size.spheres, 0, 0))
}
