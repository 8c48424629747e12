//! The regressor Y of τ = Y π for the inertial parameters π of the links, since Φ = skew\[H J\] (paper, eq. 25) is linear
//! in J.

use super::definition::{Definition, Truth};
use super::quantities;
use super::tally::{ACTION, INERTIA, MOVING, Size, Tally};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "regressor",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Qdd],
    result: quantities::REGRESSOR,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.regressor()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Regressor Y(q, q̇, q̈) of τ = Y π, by rows. π lists for each link that a joint moves, with everything \
     that is fixed to it, in the link's frame, m, q_x, q_y, q_z, J_xx, J_xy, J_xz, J_yy, J_yz, J_zz: its mass in kg, first moments \
     ∫r dm in kg m and second moments ∫rrᵗ dm in kg m², zero or not."
        .to_owned()
}

pub(super) fn dense(size: Size) -> Tally {
    // For each parameter of a link J and Φ, which loads all inboard joints of a chain.
    let parameter = INERTIA.plus(ACTION);
    let powers = Tally::default()
        .and(6, 5)
        .times(10 * size.joints * (size.joints - 1) / 2);
    let link = MOVING.plus(parameter.times(10));
    link.times(size.joints).plus(powers)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let columns = scene.regressor();
    scene.rows_of(&columns.iter().collect::<Vec<_>>())
}
