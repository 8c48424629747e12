//! The regressor of the potential energy −Σ Tr(H_g J) (paper, § 4.5), which is linear in masses and first moments.

use super::definition::{Definition, Truth};
use super::quantities;
use super::tally::{INERTIA, KINEMATIC, Size, Tally};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "potential_energy_regressor",
    sentence: |base, _| {
        format!(
            "Regressor of the potential energy of gravity, zero at the origin of {base} (frame 0): U = y(q) π for the \
             parameters π of `regressor`."
        )
    },
    arguments: &[Variable::Q],
    result: quantities::ENERGIES,
    properties: &[],
    truth: Truth::Value(|dense, _| dense.potential_energy_regressor()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn dense(size: Size) -> Tally {
    // For each parameter of a link J, and the trace of its product with H_g.
    let energy = INERTIA.and(16, 16);
    let link = KINEMATIC.plus(energy.times(10));
    link.times(size.joints)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.potential_energy_regressor()
}
