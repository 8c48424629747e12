//! How far rounding can take the results of a function.
//!
//! In: a chain, functions, their program, and what it computes with. Out: an [`Accuracy`], what
//! stands beside the price: the worst of each joint's results that share a unit. It never says less
//! than "at most": where nothing can be said that holds for every state of the range, it gives the
//! reason.

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

/// Bounds the errors of a program that computes some functions one after the other; of those that
/// solve something it says nothing.
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
