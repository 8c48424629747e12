//! Driver: runs all stages on a description and returns the generated module.
//! In: a description and a request. Out: a [`Module`]. It only connects the stages: each of them knows what it rejects,
//! leaves out or warns of.

mod about;
mod batches;
mod closure;
mod collect;
mod data;
mod left_out;
mod prepared;
#[cfg(feature = "files")]
mod review;
mod understood;

pub use closure::settled;
pub use understood::{identified, identified_if_asked, understand};

use crate::chain::Chain;
use crate::check::Check;
use crate::description::Description;
use crate::error::Errors;
use crate::module::Module;
use crate::plan::plans;
use crate::request::Request;
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
    let check = Check::of(chain)?;
    let judged = plans(chain)?.map(|planned| check.judge(planned, chain.request.scalar));
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
