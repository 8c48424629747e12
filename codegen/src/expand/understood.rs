//! What a description and a request mean, with everything that is to be said against them.
//!
//! In: a description and a request. Out: a [`Chain`]; or every mistake of both, and every doubt where the request is strict.

use super::closure::settled;
use crate::chain::{self, Chain};
use crate::check::{self, Redundancy, judge_base_parameters};
use crate::description::Description;
use crate::error::{Errors, Place};
use crate::function::Function;
use crate::plan;
use crate::real::Real;
use crate::request::Request;

/// The chain of a description, with doubts about the formulation beside those about the robot.
///
/// # Errors
/// Every mistake of the description and of the formulation; every doubt, where the request is
/// strict.
pub fn understand(description: &Description, request: &Request) -> Result<Chain, Errors> {
    check_processor(request)?;
    check_batch(request)?;
    check_prepare(request)?;
    if let Err(refusal) = request.formulation.check() {
        let mut errors = Errors::new();
        errors.push_with_hint(Place::Unknown, refusal.message, refusal.hint);
        return Err(errors);
    }
    let mut chain = settled(chain::build(description, request)?, request.strict)?;
    let mut doubts = plan::doubts(&chain, request);
    if solves_loops(&chain, request) {
        let Redundancy {
            dependent,
            warnings,
        } = check::redundancy(&chain);
        chain.report.dependent = dependent;
        doubts.extend(warnings);
    }
    if request.strict && !doubts.is_empty() {
        let mut errors = chain.description.source.errors();
        for doubt in doubts {
            errors.push(doubt.place, format!("{} (refused: strict)", doubt.message));
        }
        return Err(errors);
    }
    chain.report.warnings.extend(doubts);
    Ok(chain)
}

/// Whether forces or accelerations under loops are asked for.
fn solves_loops(chain: &Chain, request: &Request) -> bool {
    let items = request.items(!chain.loops.is_empty());
    let mut functions = items.iter().flatten();
    !chain.loops.is_empty() && functions.any(|function| function.is_constrained())
}

/// Refuses a type of number that the processor would call a library for.
fn check_processor(request: &Request) -> Result<(), Errors> {
    let mut errors = Errors::new();
    if !request.processor.has(request.scalar) {
        errors.push_with_hint(
            Place::Unknown,
            format!(
                "{} computes f64 in software, operation by operation",
                request.processor.name()
            ),
            "choose f32 as the scalar, or another processor",
        );
    }
    errors.into_result(())
}

/// Refuses batches of functions that are not of numbers of any kind, and so not of packs.
fn check_batch(request: &Request) -> Result<(), Errors> {
    let mut errors = Errors::new();
    if request.batch && request.scalar != Real::Generic {
        errors.push_with_hint(
            Place::Unknown,
            "`batch` needs functions of any type of number: its types are packs",
            "leave out `scalar`; batches are of f32 and f64 alike",
        );
    }
    errors.into_result(())
}

/// Refuses to compute once what there is nothing of.
fn check_prepare(request: &Request) -> Result<(), Errors> {
    let mut errors = Errors::new();
    if request.prepare && request.parameters.is_empty() {
        errors.push_with_hint(
            Place::Unknown,
            "`prepare` computes once what depends on fields alone, and the robot has none",
            "leave it out: all other numbers are folded into the code",
        );
    }
    errors.into_result(())
}

/// The same chain with its base parameters, held against the description.
///
/// # Errors
/// Where they cannot be told apart, or are wrong.
pub fn identified(chain: Chain) -> Result<Chain, Errors> {
    let chain = chain.identified();
    judge_base_parameters(&chain)?;
    Ok(chain)
}

/// The same chain, with its base parameters where a function of them is asked for.
#[must_use]
pub fn identified_if_asked(chain: Chain) -> Chain {
    if chain.request.asks_for(Function::BaseRegressor) {
        chain.identified()
    } else {
        chain
    }
}
