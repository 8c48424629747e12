//! Bounds of rounding errors: how far the results of a function can be from the exact ones.
//!
//! In: a chain, functions, their program and its arithmetic. Out: an [`Accuracy`], which is documented
//! beside the operation count: the worst error of each joint's results that share a unit. Every bound
//! holds in all states of the range; where none is known, the reason is given.

mod articulated;
pub mod mobility;
mod planned;
mod promise;
mod solved;

pub use self::articulated::Articulated;
pub use self::planned::of_plan;
pub use self::promise::{Accuracy, Bound, Means, Perturbed, Promise};
pub use self::solved::{of_accelerations, of_derivatives, of_inverse, of_refined_inverse};

use self::promise::{Owner, Worst, computed, error, owners, promise};
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
    means: Means,
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
        let found = computed(program, &range, means, scalar);
        let found = kept.iter().map(|&k| found[k]);
        found.map(error).collect()
    };
    let evaluated = functions.iter().filter(|function| evaluated(function));
    let actions = chain.spaces().actions() > 0;
    let arguments = evaluated.map(|function| function.arguments_with(actions));
    let arguments = Variable::together(arguments);
    let promise = promise(chain, means, &owners, worst);
    Some(match promise {
        Ok(promise) => Accuracy::Within(promise.within(chain, &arguments, &[program], means)),
        Err(reason) => Accuracy::Unknown(reason),
    })
}
