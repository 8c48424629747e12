//! Interpretation of a description and a request, with all errors and warnings.
//!
//! In: a description and a request. Out: a [`Chain`]; or every error of both, and every warning if the request is
//! strict.

use super::closure::settled;
use crate::chain::{self, Chain};
use crate::check::{self, Redundancy, judge_base_parameters};
use crate::description::Description;
use crate::error::{Errors, Place};
use crate::formulation::{Products, Sines};
use crate::function::Function;
use crate::plan;
use crate::real::Real;
use crate::request::Request;

/// The chain of a description, with warnings about the formulation and about the robot.
///
/// # Errors
/// Every error of the description and of the formulation; every warning, if the request is strict.
pub fn understand(description: &Description, request: &Request) -> Result<Chain, Errors> {
    check_processor(request)?;
    check_batch(request)?;
    check_prepare(request)?;
    check_reproducible(request)?;
    if let Err(refusal) = request.formulation.check() {
        let mut errors = Errors::new();
        errors.push_with_hint(Place::Unknown, refusal.message, refusal.hint);
        return Err(errors);
    }
    let request = &unfused_if_reproducible(request);
    let mut chain = settled(chain::build(description, request)?, request.strict)?;
    let mut warnings = plan::warnings(&chain, request);
    if solves_loops(&chain, request) {
        let Redundancy {
            elimination,
            dependent,
            warnings: of_loops,
        } = check::redundancy(&chain);
        chain.elimination = elimination;
        chain.report.dependent = dependent;
        warnings.extend(of_loops);
    }
    if request.strict && !warnings.is_empty() {
        let mut errors = chain.description.source.errors();
        for warning in warnings {
            errors.push(
                warning.place,
                format!("{} (refused: strict)", warning.message),
            );
        }
        return Err(errors);
    }
    chain.report.warnings.extend(warnings);
    Ok(chain)
}

/// True if constrained dynamics of closed loops is requested.
fn solves_loops(chain: &Chain, request: &Request) -> bool {
    let items = request.items(!chain.loops.is_empty());
    let mut functions = items.iter().flatten();
    !chain.loops.is_empty() && functions.any(|function| function.is_constrained())
}

/// Rejects a scalar type that the processor has no instructions for.
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

/// Rejects `batch` without generic scalars: its types are packs.
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

/// Rejects `prepare` on a robot without run-time fields.
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

/// Rejects `reproducible` with the sines of the platform, which differ between platforms.
fn check_reproducible(request: &Request) -> Result<(), Errors> {
    let mut errors = Errors::new();
    if request.reproducible && request.formulation.sines == Sines::Platform {
        errors.push_with_hint(
            Place::Unknown,
            "`reproducible` contradicts `platform_sines`: the sines of platforms differ in the last digit",
            "leave one of them out",
        );
    }
    errors.into_result(())
}

/// The same request; without fused products if it is to be reproducible.
fn unfused_if_reproducible(request: &Request) -> Request {
    let mut request = request.clone();
    if request.reproducible {
        request.formulation.products = Products::Unfused;
    }
    request
}

/// The same chain with its base parameters, which are compared with the description.
///
/// # Errors
/// If they cannot be determined, or are wrong.
pub fn identified(chain: Chain) -> Result<Chain, Errors> {
    let chain = chain.identified();
    judge_base_parameters(&chain)?;
    Ok(chain)
}

/// The same chain, with its base parameters if a function of them is requested.
#[must_use]
pub fn identified_if_asked(chain: Chain) -> Chain {
    if chain.request.asks_for(Function::BaseRegressor) {
        chain.identified()
    } else {
        chain
    }
}
