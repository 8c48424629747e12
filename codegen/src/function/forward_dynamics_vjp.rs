//! Vector–Jacobian product of forward dynamics: the gradient of λᵀq̈ by q, q̇ and τ. With y = M⁻¹ λ it is that of −yᵀτ
//! by q and q̇ at constant q̈, and y.

use super::definition::{Definition, Given, Property, Truth};
use super::tally::{Size, Tally};
use super::{forward_dynamics, inverse_dynamics_vjp, quantities};
use crate::expression::Term;
use crate::model::{FreeFall, Scene};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "forward_dynamics_vjp",
    sentence,
    arguments: &[Variable::Q, Variable::Qd, Variable::Tau, Variable::Weights],
    result: quantities::ACCELERATION_GRADIENT,
    properties: &[Property::Mass, Property::External],
    truth: Truth::Solution(Given::Gradient),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Vector–Jacobian product of forward dynamics: (∂q̈/∂q)ᵀ λ, (∂q̈/∂q̇)ᵀ λ and (∂q̈/∂τ)ᵀ λ = M⁻¹ λ, for \
     weights λ, in N m or N, of the joint accelerations that τ produces against gravity."
        .to_owned()
}

fn dense(size: Size) -> Tally {
    let squares = size.joints.pow(2);
    let parts = forward_dynamics::dense(size).plus(inverse_dynamics_vjp::dense(size));
    parts.and(squares, squares)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let falling = FreeFall::of(scene);
    let scene = falling.scene();
    let accelerations = forward_dynamics::accelerations(scene);
    let moved = forward_dynamics::of_weights(scene);
    let parts = falling.torque_gradient([&accelerations, &moved]);
    let gradients = parts.iter().zip(falling.gradient(&scene.weights()));
    let sums = gradients.flat_map(|(part, fall)| {
        let sums = part.iter().zip(&fall).map(|(&entry, &fall)| fall - entry);
        sums.collect::<Vec<_>>()
    });
    sums.chain(Vec::from(moved)).collect()
}
