//! The programs that the engine plans for a chain.
//!
//! In: a chain, functions; a formulation and a scalar type, which replace those of its request. Out: the program of the
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

/// The program of several functions together, in the default formulation.
///
/// # Errors
/// Those of [`plan`].
///
/// # Panics
/// Those of [`plan`].
pub fn program(
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    scalar: Real,
) -> Result<Program, Errors> {
    program_as(Formulation::default(), chain, functions, frame, scalar)
}

/// The program of several functions together, in a formulation.
///
/// # Errors
/// Those of [`plan`].
///
/// # Panics
/// Those of [`plan`].
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
