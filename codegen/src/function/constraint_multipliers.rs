//! What holds the loops together while forces and torques move the joints.

use super::constrained_forward_dynamics;
use super::definition::{Definition, Truth};
use super::quantities;
use super::tally::{Size, Tally};
use crate::expression::Term;
use crate::model::Scene;
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "constraint_multipliers",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Tau],
    result: quantities::MULTIPLIERS,
    of_a_frame: false,
    truth: Truth::Constrained(|dense, vanishing| dense.constrained(vanishing).1),
    ways: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Multipliers λ of the residuals of the loops in the motion of constrained_forward_dynamics: forces \
     on B along the axes of A in N, for products of axes torques in N m; along a rod its force in N, positive \
     where it pushes. Those of residuals that are left out are zero."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    constrained_forward_dynamics::dense(size)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    scene.constrained().1
}
