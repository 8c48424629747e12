//! Error bounds of the results of a plan: of all results that are evaluated, and of each function that solves an
//! equation.
//!
//! In: a [`Plan`], which knows the programs that a bound needs. Out: an [`Accuracy`] of each.

use std::cell::OnceCell;

use super::{
    Accuracy, Articulated, RoundingModel, of, of_accelerations, of_derivatives, of_inverse,
    of_refined_inverse,
};
use crate::formulation::Forward;
use crate::function::{Function, Given, Truth};
use crate::plan::{Plan, keeps_half};
use crate::real::Real;

/// Reason why solutions have no bound in `f32`.
const LESS_THAN_HALF: &str = "less than half of the digits may be left";

/// Bounds the results of a plan.
#[must_use]
pub fn of_plan(plan: &Plan<'_>, rounding: RoundingModel) -> Vec<Accuracy> {
    let evaluated = of(plan.chain, &plan.functions, &plan.program, rounding);
    let bounds = evaluated.into_iter().chain(solved(plan, rounding));
    // Programs that the check would refuse in f32, for the same loss in units of u, have no bound there.
    if rounding.scalar != Real::Generic || keeps_half(plan.error.worst, Real::F32) {
        return bounds.collect();
    }
    let bounds = bounds.map(|accuracy| match accuracy {
        solved @ (Accuracy::Backward(..) | Accuracy::BesideDiagonal(_)) => {
            solved.without_single(LESS_THAN_HALF)
        }
        other => other,
    });
    bounds.collect()
}

/// Bounds each function that solves an equation; a bound that several share is listed once.
fn solved(plan: &Plan<'_>, rounding: RoundingModel) -> Vec<Accuracy> {
    let has_residual = has_residual(plan.algorithm.forward);
    let solutions = Solutions::of(plan, rounding);
    let mut listed = Vec::new();
    let mut bounds = Vec::new();
    for function in &plan.functions {
        let Truth::Solution(given) = function.truth() else {
            if function.is_constrained() {
                let reason = "none is derived where loops are held together";
                bounds.push(Accuracy::Unknown(reason));
            }
            continue;
        };
        // Derivatives are taken at the accelerations found, with a computed M⁻¹; each has its own bound. The bounds
        // of the inverse are all that is known of a product with it.
        let givens: &[Given] = match given {
            Given::TorqueDerivatives if !has_residual => {
                &[Given::Torques, Given::TorqueDerivatives, Given::MassMatrix]
            }
            _ => &[given],
        };
        for &given in givens {
            if !listed.contains(&given) {
                listed.push(given);
                bounds.push(solutions.solution(given));
            }
        }
    }
    bounds
}

const fn has_residual(forward: Forward) -> bool {
    matches!(forward, Forward::MassMatrix { refinements: 1.. })
}

/// Data that bounds of solutions need.
struct Solutions<'p> {
    plan: &'p Plan<'p>,
    rounding: RoundingModel,
    bodies: OnceCell<Result<Articulated<'p>, &'static str>>,
}

impl<'p> Solutions<'p> {
    const fn of(plan: &'p Plan<'p>, rounding: RoundingModel) -> Self {
        Self {
            plan,
            rounding,
            bodies: OnceCell::new(),
        }
    }

    fn solution(&self, given: Given) -> Accuracy {
        let &Plan {
            chain,
            layout,
            algorithm,
            ref programs,
            ..
        } = self.plan;
        let rounding = self.rounding;
        let equation = || programs.equation(layout, algorithm, has_residual(algorithm.forward));
        let torque_derivatives = || programs.torque_derivatives(layout, algorithm);
        let fall = || programs.free_fall(layout);
        match (given, algorithm.forward) {
            (Given::Torques, Forward::MassMatrix { refinements }) => {
                of_accelerations(chain, [&equation(), &fall()], refinements, rounding)
            }
            (Given::Torques, Forward::Articulated) => {
                self.of_bodies(|bodies| bodies.accelerations(rounding))
            }
            (Given::MassMatrix, Forward::Articulated) => {
                self.of_bodies(|bodies| bodies.inverse(rounding))
            }
            (Given::TorqueDerivatives, Forward::Articulated) => {
                self.of_bodies(|bodies| bodies.derivatives(&torque_derivatives(), rounding))
            }
            (Given::MassMatrix, Forward::UNREFINED) => {
                let mass_matrix = programs.function(Function::MassMatrix, layout, algorithm);
                of_inverse(chain, &mass_matrix, rounding)
            }
            (Given::MassMatrix, Forward::MassMatrix { refinements }) => {
                let at_rest = programs.equation_at_rest(layout, algorithm);
                of_refined_inverse(chain, &at_rest, refinements, rounding)
            }
            (Given::TorqueDerivatives, Forward::UNREFINED) => of_derivatives(
                chain,
                [&equation(), &torque_derivatives(), &fall()],
                rounding,
            ),
            (Given::TorqueDerivatives, _) => {
                Accuracy::Unknown("none is derived of an inverse that is refined")
            }
            (Given::Regressor | Given::Change, _) => {
                Accuracy::Unknown("none is derived of products with M⁻¹")
            }
            (Given::Gradient | Given::Hessian, _) => {
                Accuracy::Unknown("none is derived of products with M⁻¹ λ")
            }
        }
    }

    fn of_bodies(&self, bounds: impl Fn(&Articulated<'_>) -> Accuracy) -> Accuracy {
        let Plan {
            programs,
            layout,
            algorithm,
            ..
        } = self.plan;
        let bodies = self
            .bodies
            .get_or_init(|| Articulated::of(programs, *layout, *algorithm));
        match bodies {
            Ok(bodies) => bounds(bodies),
            Err(reason) => Accuracy::Unknown(reason),
        }
    }
}
