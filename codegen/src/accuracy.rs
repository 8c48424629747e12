//! Bounds of rounding errors: how far the results of a function can be from the exact ones.
//!
//! In: a chain, functions, their program and its arithmetic. Out: an [`Accuracy`], which is documented
//! beside the operation count: the worst error of each joint's results that share a unit. Every bound
//! holds in all states of the range; where none is known, the reason is given.

mod articulated;
mod error_bounds;
mod free_fall;
pub mod mobility;
mod planned;
mod solved;

pub use self::articulated::Articulated;
pub use self::error_bounds::{Accuracy, Bound, ErrorBounds, Perturbed, RoundingModel};
pub use self::planned::of_plan;
pub use self::solved::{of_accelerations, of_derivatives, of_inverse, of_refined_inverse};

use self::error_bounds::{Owner, Worst, computed, error, error_bounds, owners};
use crate::chain::Chain;
use crate::function::Function;
use crate::range::Range;
use crate::real::Real;
use crate::schedule::Program;
use crate::space::Variable;

/// Bounds the errors of a program that computes some functions one after the other. `None` if all of
/// them solve an equation; [`of_plan`] bounds those.
#[must_use]
pub fn of(
    chain: &Chain,
    functions: &[Function],
    program: &Program,
    rounding: RoundingModel,
) -> Option<Accuracy> {
    let evaluated = |function: &&Function| !(function.solves() || function.is_constrained());
    let results = functions.iter().flat_map(|function| {
        let owners = owners(chain, *function).into_iter();
        owners.map(move |owner| evaluated(&function).then_some(owner))
    });
    let (kept, owners): (Vec<usize>, Vec<Owner>) = results
        .enumerate()
        .filter_map(|(k, owner)| Some((k, owner?)))
        .unzip();
    if owners.is_empty() {
        return None;
    }
    let range = Range::of(chain);
    let worst = |scalar: Real| -> Worst {
        let found = computed(program, &range, rounding, scalar);
        let found = kept.iter().map(|&k| found[k]);
        found.map(error).collect()
    };
    let evaluated = functions.iter().filter(|function| evaluated(function));
    let actions = chain.spaces().actions() > 0;
    let arguments = evaluated.map(|function| function.arguments_with(actions));
    let arguments = Variable::together(arguments);
    let error_bounds = error_bounds(chain, rounding, &owners, worst);
    Some(match error_bounds {
        Ok(error_bounds) => {
            Accuracy::Within(error_bounds.within(chain, &arguments, &[program], rounding))
        }
        Err(reason) => Accuracy::Unknown(reason),
    })
}
