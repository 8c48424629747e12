//! Which of the programs that compute the same is taken.
//!
//! In: a chain, the functions that are asked for together, a formulation. Out: the [`Program`](crate::schedule::Program) that
//! costs least on a processor, of all layouts of the frames and all ways that compute them. It never
//! looks at values: where something is solved for, [`accurate`] finds the form that loses little enough.

use super::accurate::accurate;
use super::forward::{self, Form};
use super::identifiable::settled;
use super::search::{Found, Search};
use super::solvable::solvable;
use super::weighable::weighable;
use crate::chain::Chain;
use crate::error::{Errors, Place};
use crate::formulation::{Formulation, Forward};
use crate::function::Function;
use crate::processor::Processor;
use crate::real::Real;
use crate::space::FrameId;
use crate::wording::quoted;

/// The program that is cheapest on a processor, within a formulation, of some functions together, of a frame of the chain.
///
/// # Errors
/// Where forward dynamics, or the inverse of the mass matrix, is asked for of a chain that has none, or
/// that no form leaves half of the digits in this type of number, unless the formulation asks for the form; where a centre
/// of mass is asked for of one without mass.
///
/// # Panics
/// Where a function of a frame is asked for and the chain has none.
pub(super) fn cheapest(
    processor: Processor,
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    scalar: Real,
) -> Result<Found, Errors> {
    if functions.iter().any(|function| function.is_of_mass()) {
        weighable(chain)?;
    }
    closable(chain, functions)?;
    if functions.contains(&Function::BaseRegressor) {
        settled(chain)?;
    }
    let search = Search::new(processor, formulation, chain, functions, frame, scalar);
    if !functions.iter().any(|function| function.solves()) {
        let inverts = |function: &Function| function.is_constrained() && !function.wants_drives();
        if functions.iter().any(inverts) {
            solvable(chain)?;
            return Ok(search.best(Form::full(Forward::UNREFINED)).1);
        }
        return Ok(search.best(Form::sparing(Forward::UNREFINED)).1);
    }
    let worst = solvable(chain)?;
    if let Some(asked) = formulation.forward {
        forward::check(chain, asked)?;
        return Ok(search.best(Form::sparing(asked)).1);
    }
    accurate(&search, worst)
}

/// Refuses what is of loops where there are none.
fn closable(chain: &Chain, functions: &[Function]) -> Result<(), Errors> {
    let mut errors = chain.description.source.errors();
    let of_loops = functions.iter().filter(|function| function.is_of_loops());
    for function in of_loops.filter(|_| chain.loops.is_empty()) {
        let name = quoted(function.name());
        errors.push_with_hint(
            Place::Unknown,
            format!("{name} is of robots with loops, and this one has none"),
            "close one: loop pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.1, 0, 0) }",
        );
    }
    if let Some(function) = functions.iter().find(|function| function.wants_drives())
        && !chain.actuated.contains(&true)
    {
        let name = quoted(function.name());
        let message = format!("{name} asks which joints are driven");
        errors.push_with_hint(Place::Unknown, message, "name them: actuated(crank)");
    }
    errors.into_result(())
}
