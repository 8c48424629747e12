//! Programs that the engine chooses for a chain.
//!
//! In: a chain, functions, a formulation and a type of number in place of those of its request. Out: the program of the
//! plan.

use std::rc::Rc;

use homogen_codegen::chain::Chain;
use homogen_codegen::error::Errors;
use homogen_codegen::formulation::Formulation;
use homogen_codegen::function::Function;
use homogen_codegen::plan::{Programs, plan};
use homogen_codegen::real::Real;
use homogen_codegen::schedule::Program;
use homogen_codegen::space::FrameId;

/// The program of some functions together in the default formulation.
///
/// # Errors
/// As [`plan`] has them.
///
/// # Panics
/// As [`plan`] does.
pub fn program(
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    scalar: Real,
) -> Result<Program, Errors> {
    program_as(Formulation::default(), chain, functions, frame, scalar)
}

/// The program of some functions together within a formulation.
///
/// # Errors
/// As [`plan`] has them.
///
/// # Panics
/// As [`plan`] does.
pub fn program_as(
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    scalar: Real,
) -> Result<Program, Errors> {
    let mut chain = chain.clone();
    let request = Rc::make_mut(&mut chain.request);
    (request.formulation, request.scalar) = (formulation, scalar);
    let plan = plan(&Programs::of(&chain), functions.to_vec(), frame)?;
    Ok(plan.program)
}
