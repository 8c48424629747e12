//! Derivatives of forward dynamics by the inertial parameters: ∂q̈/∂π = −M⁻¹ Y, with the regressor Y at q̈.
//!
//! An entry is the power of the wrench of a unit parameter along the motion of its link that a unit torque at a joint
//! causes, with the opposite sign. So rows cost a recursion outwards each, where columns cost a solution each, of which
//! there are ten a link.

use super::definition::{Definition, Given, Property, Truth};
use super::tally::{Size, Tally};
use super::{forward_dynamics, mass_matrix_inverse, quantities, regressor};
use crate::expression::Term;
use crate::list::List;
use crate::model::{FreeFall, Scene};
use crate::space::{Variable, VelocityId};

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_dynamics_parameter_derivatives",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Tau],
    result: quantities::ACCELERATIONS_BY_PARAMETERS,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Solution(Given::Regressor),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Derivatives ∂q̈/∂π = −M⁻¹ Y of the joint accelerations that τ produces against gravity, by the parameters π of \
     `regressor`, a row for each acceleration."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    // q̈, Y, and a product with M⁻¹.
    let parts = forward_dynamics::dense(size).plus(regressor::dense(size));
    let product = 10 * size.joints.pow(3);
    parts.and(product, product)
}

/// Length of chains up to which columns take fewer operations than rows.
const FEW: usize = 3;

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let falling = FreeFall::of(scene);
    let scene = falling.scene();
    let accelerations = forward_dynamics::accelerations(scene);
    let negated = |entries: List<VelocityId, Term<'g>>| entries.map(|&entry| -entry);
    if scene.longest_path() <= FEW {
        let columns = falling.regressor(&accelerations).into_iter().map(negated);
        let found = mass_matrix_inverse::times(scene, &columns.collect::<Vec<_>>());
        return scene.rows_of(&found.iter().collect::<Vec<_>>());
    }
    let inverse = mass_matrix_inverse::inverse(scene);
    let rows: Vec<_> = inverse.rows().map(negated).collect();
    falling.regressor_along(&accelerations, &rows).concat()
}
