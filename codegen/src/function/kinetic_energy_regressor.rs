//! The regressor of the kinetic energy ½ Σ Tr(W J Wᵗ) (paper, eq. 22), which is linear in J and in the armatures.

use super::definition::{Definition, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally, VELOCITY};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "kinetic_energy_regressor",
    sentence: |_, _| {
        "Regressor of the kinetic energy: T = y(q, q̇) π for the parameters π of `regressor`."
            .to_owned()
    },
    arguments: &[Variable::Q, Variable::Qd],
    result: quantities::ENERGIES,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.kinetic_energy_regressor()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // For each parameter of a link J, W J, and the trace of its product with Wᵗ alone.
    let energy = INERTIA.plus(Tally::of(1, 0, 0)).and(16, 16);
    let link = KINEMATIC.plus(VELOCITY).plus(energy.times(10));
    link.times(size.joints)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.kinetic_energy_regressor()
}
