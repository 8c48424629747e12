//! Driver: runs all stages on a description and returns the generated module.
//! In: a description and a request. Out: a [`Module`]. It only connects the stages: each of them knows what it rejects,
//! leaves out or warns of.

mod about;
mod batches;
mod closure;
mod collect;
mod configurations;
mod data;
mod left_out;
mod prepared;
#[cfg(feature = "files")]
mod review;
mod understood;

pub use closure::settled;
pub use configurations::configurations;
pub use understood::{identified, identified_if_asked, understand};

use crate::chain::Chain;
use crate::check::Check;
use crate::description::Description;
use crate::error::Errors;
use crate::function::Function;
use crate::module::Module;
use crate::plan::{Planned, Programs, check_size, planned, plans};
use crate::request::Request;
use crate::space::FrameId;
use collect::collect;

/// Expands a robot.
///
/// # Errors
/// Every mistake of the description and of the request.
pub fn expand(description: &Description, request: &Request) -> Result<Module, Errors> {
    of_chain(&identified_if_asked(understand(description, request)?))
}

/// Expands a robot that has been interpreted, with its base parameters if they are requested.
///
/// # Errors
/// Every mistake of the request.
pub fn of_chain(chain: &Chain) -> Result<Module, Errors> {
    collected(chain, &Check::of(chain)?, plans(chain)?)
}

/// Expands some functions of a robot together, for a frame; `check` is that of the chain. Callers that show functions
/// one at a time do not wait for the others.
///
/// # Errors
/// Every mistake of the request.
///
/// # Panics
/// If a function of a frame is requested and the chain has none.
pub fn one(
    chain: &Chain,
    check: &Check,
    functions: Vec<Function>,
    frame: FrameId,
) -> Result<Module, Errors> {
    check_size(chain)?;
    let planned = planned(&Programs::of(chain), functions, frame);
    collected(chain, check, std::iter::once(planned))
}

/// The module of plans, which are compared with the description.
fn collected<'c>(
    chain: &Chain,
    check: &Check,
    plans: impl Iterator<Item = Planned<'c>>,
) -> Result<Module, Errors> {
    let judged = plans.map(|planned| check.judge(planned, chain.request.scalar));
    let (module, mut errors) = collect(chain, judged);
    if let Err(refusal) = check.judge_module(&module) {
        errors.append(refusal);
    }
    errors.into_result(module)
}

/// The robot without functions: names, limits, loops, and the functions of configurations that need nothing else.
#[must_use]
pub fn without_functions(chain: &Chain) -> Module {
    let (module, _) = collect(chain, std::iter::empty());
    module
}

#[cfg(test)]
mod long_chains;
#[cfg(test)]
mod tests;
