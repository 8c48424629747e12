//! The centre of mass of all bodies that joints move. The last column of Σ J has the first moments and the mass (paper,
//! eq. 16).

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally};
use crate::expression::Term;
use crate::model::{MassCenter, Scene};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "center_of_mass",
    sentence: |base, _| {
        format!(
            "Centre of mass of all bodies that joints move, in {base} (frame 0); m. Bodies fixed to {base} are not included."
        )
    },
    arguments: &[Variable::Q],
    result: quantities::POINT,
    properties: &[Property::Mass],
    truth: Truth::OfMass(|dense, _| dense.mass_center().to_vec()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // The sum of all J, and three divisions.
    let link = KINEMATIC.plus(INERTIA).plus(Tally::of(0, 0, 1));
    link.times(size.joints).and(3, 0)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let joints = scene.joints();
    MassCenter::of(&joints, &scene.bodies.base)
        .point()
        .0
        .to_vec()
}
