//! The distances between collision spheres.

use super::definition::{Definition, Truth};
use super::tally::{Size, Tally};
use super::{forward_kinematics, quantities, sphere_centers};
use crate::model::spheres;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "distances",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::DISTANCES,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.distances()),
    algorithms: forward_kinematics::algorithms,
    dense,
    build: spheres::distances,
};

fn sentence(_: &str, _: &str) -> String {
    "Distances |c₁ − c₂| − r₁ − r₂ of pairs of collision spheres, in m; negative where they overlap.".to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    sphere_centers::dense(size).and(4 * size.pairs, 6 * size.pairs)
}
