//! The Coriolis matrix by the Christoffel symbols of M: C q̇ are the Coriolis and centrifugal torques and forces.

use super::definition::{Definition, Property, Truth};
use super::tally::{Size, Tally, VELOCITY};
use super::{mass_matrix, quantities};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "coriolis_matrix",
    sentence,
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::DAMPING,
    properties: &[Property::Mass, Property::BodiesAlone],
    truth: Truth::Value(|dense, _| dense.coriolis_matrix().into()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Coriolis matrix C(q, q̇) of τ = M q̈ + C q̇ + gravity, by rows, with Ṁ − 2C skew-symmetric; \
     N m s, N s, N s/m."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    // Twice the work of M, W J of each body, and L̇ J + L W J of each column.
    let velocity = VELOCITY.plus(Tally::of(1, 0, 1));
    let column = Tally::of(4, 0, 2);
    let parts = mass_matrix::dense(size).times(2);
    parts.plus(velocity.plus(column).times(size.joints))
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.coriolis_matrix().into()
}
