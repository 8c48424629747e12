//! The joint-space inertia matrix.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "mass_matrix",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::INERTIAS,
    properties: &[Property::Mass],
    truth: Truth::Value(|dense, _| dense.mass_matrix().clone().into()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint-space inertia matrix M(q) of τ = M q̈ + bias, by rows; kg m², kg m, kg.".to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    // For each column a composite J and L J, for each entry Tr(Lᵢ J Lₘᵗ).
    let column = KINEMATIC.plus(INERTIA).plus(Tally::of(1, 0, 1));
    let entry = Tally::default().and(16, 15);
    let entries = entry.times(size.joints * (size.joints + 1) / 2);
    column.times(size.joints).plus(entries)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.mass_matrix().into()
}
