//! The centroidal momentum matrix: for each joint Σ skew\[L J\] over the bodies that it carries.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally};
use crate::expression::Term;
use crate::model::{MassCenter, Scene, momentum};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "centroidal_momentum_matrix",
    sentence: |base, _| {
        format!(
            "Centroidal momentum matrix: momentum Γ of all bodies that joints move about their centre of mass, at unit velocity of each degree of freedom, in the axes of {base} (frame 0)."
        )
    },
    arguments: &[Variable::Q],
    result: quantities::MOMENTA,
    properties: &[Property::Mass, Property::BodiesAlone],
    truth: Truth::OfMass(|dense, _| {
        let momenta = dense.unit_moments().map(|moments| moments.skew());
        let momenta = momenta.map(|momentum| dense.about_mass_center(&momentum).vectors());
        momenta.flatten().collect()
    }),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // For each column a composite J, L J and a change of frame.
    let column = KINEMATIC.plus(INERTIA).plus(Tally::of(3, 0, 2));
    column.times(size.joints).and(3, 0)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let (joints, base) = scene.seen_from_root();
    let center = MassCenter::of(&joints, &base).point();
    let columns = momentum::columns(&joints, center);
    scene.gathered(&columns.map(|column| column.entries()))
}
