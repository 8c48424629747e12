//! The choice among programs that compute the same.
//!
//! In: a chain, the functions that are requested together, a formulation. Out: the
//! [`Program`](crate::schedule::Program) with the least cost on a processor, over all layouts of frames and all
//! algorithms. Functions that solve an equation are left to [`accurate`], which finds a form that loses few digits.

use super::accurate::accurate;
use super::forward::{self, ForwardForm};
use super::identifiable::settled;
use super::search::{ChosenProgram, Search};
use super::solvable::solvable;
use super::weighable::weighable;
use crate::chain::Chain;
use crate::error::{Errors, Place};
use crate::formulation::{Formulation, Forward};
use crate::function::Function;
use crate::processor::Processor;
use crate::real::Real;
use crate::space::{FrameId, Space};
use crate::wording::quoted;

/// The cheapest program on a processor, within a formulation, of some functions together, for a frame of the chain.
///
/// # Errors
/// If forward dynamics, or the inverse of the mass matrix, is requested for a chain that has none, or for which no form
/// leaves half of the digits in this scalar type, unless the formulation names the form; if a centre of mass is
/// requested for a chain without mass.
///
/// # Panics
/// If a function of a frame is requested and the chain has none.
pub(super) fn cheapest(
    processor: Processor,
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    scalar: Real,
) -> Result<ChosenProgram, Errors> {
    if functions.iter().any(|function| function.is_of_mass()) {
        weighable(chain)?;
    }
    possible(chain, functions)?;
    if functions.contains(&Function::BaseRegressor) {
        settled(chain)?;
    }
    let search = Search::new(processor, formulation, chain, functions, frame, scalar);
    if !functions.iter().any(|function| function.solves()) {
        let inverts =
            |function: &Function| function.is_constrained() && !function.wants_actuators();
        if functions.iter().any(inverts) {
            solvable(chain)?;
            return Ok(search.best(ForwardForm::full(Forward::UNREFINED)).1);
        }
        return Ok(search.best(ForwardForm::sparing(Forward::UNREFINED)).1);
    }
    let worst = solvable(chain)?;
    if let Some(asked) = formulation.forward {
        forward::check(chain, asked)?;
        return Ok(search.best(ForwardForm::sparing(asked)).1);
    }
    accurate(&search, worst)
}

/// Rejects functions of loops for a robot without loops, and those of distances for one whose spheres have none.
fn possible(chain: &Chain, functions: &[Function]) -> Result<(), Errors> {
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
    let mut of_pairs = functions
        .iter()
        .filter(|function| function.further().contains(&Space::Pairs));
    if let Some(function) = of_pairs.next()
        && chain.pairs.is_empty()
    {
        let message = format!(
            "{} is of pairs of spheres, and no two spheres move relative to each other",
            quoted(function.name())
        );
        let hint = "spheres of neighbours are pairs where they are named: collision(hand: arm)";
        errors.push_with_hint(Place::Unknown, message, hint);
    }
    if let Some(function) = functions.iter().find(|function| function.wants_actuators())
        && !chain.actuated.contains(&true)
    {
        let name = quoted(function.name());
        let message = format!("{name} needs the actuated joints");
        errors.push_with_hint(Place::Unknown, message, "name them: actuated(crank)");
    }
    errors.into_result(())
}
