//! The derivatives of the distances between collision spheres by q.

use super::definition::{Definition, Truth};
use super::tally::{SCREW, Size, Tally};
use super::{distances, quantities};
use crate::model::spheres;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "distance_jacobian",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::DISTANCE_DERIVATIVES,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.distance_jacobian()),
    algorithms: Definition::one_way,
    dense,
    build: spheres::jacobian,
};

fn sentence(_: &str, _: &str) -> String {
    "Derivatives of the distances of pairs of collision spheres by q, a row for each pair; m, or 1 for translations. They \
     are not finite where two centres coincide."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    // For each pair a normal and its moment, and L ⊗ Φ of each joint.
    let row = Tally::default()
        .and(10, 3)
        .plus(Tally::default().and(6, 5).times(size.joints));
    distances::dense(size)
        .plus(SCREW.times(size.joints))
        .plus(row.times(size.pairs))
}
