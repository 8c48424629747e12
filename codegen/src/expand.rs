//! The way through the house: from a description to everything that is printed for it.
//!
//! In: a description, a request, the struct that gets the functions. Out: a [`Listing`]. It only
//! connects the stages: where they offer more than one way, `forward` decides by accuracy, and
//! `choice` between those that are left by count.

mod about;
mod choice;
mod data;
mod forward;

pub use choice::{expressions_by, program, program_as, program_by, program_for};

use crate::accuracy::{self, Accuracy, Means};
use crate::chain::{self, Chain};
use crate::check::Check;
use crate::description::Description;
use crate::emit::{Item, Listed, Listing};
use crate::error::{Errors, Place};
use crate::formulation::{Forward, Sines};
use crate::function::Function;
use crate::model;
use crate::request::{Real, Request, Trigonometry};
use crate::schedule::Price;
use about::about;
use choice::{Found, cheapest};
use data::data;

/// Expands a robot.
///
/// # Errors
/// Every mistake of the description and of the request.
pub fn expand(description: &Description, request: &Request, item: Item) -> Result<Listing, Errors> {
    let chain = understand(description, request)?;
    check_size(&chain)?;
    let check = Check::of(description, request, &chain)?;
    let mut errors = Errors::new();
    let mut functions = Vec::new();
    for (wanted, frame) in wanted(&chain, request) {
        match list(&chain, wanted, frame, request) {
            Ok(listed) => {
                match check.judge(&listed.functions, frame, &listed.program, request.scalar) {
                    Ok(()) => functions.push(listed),
                    Err(fault) => errors.append(fault),
                }
            }
            // Of all that a robot can have, what it cannot have is left out.
            Err(_) if request.functions.is_empty() => {}
            Err(refusal) => errors.append(refusal),
        }
    }
    let data = data(&chain);
    if let Err(refusal) = check.judge_data(&data) {
        errors.append(refusal);
    }
    errors.into_result(Listing {
        item,
        about: about(description, &chain, request.formulation),
        functions,
        data,
        scalar: request.scalar,
        sines: request.formulation.sines,
        parameters: request.parameters.clone(),
        runtime: request.runtime.clone(),
        watched: None,
    })
}

/// The chain of a description, with doubts about the formulation beside those about the robot.
///
/// # Errors
/// Every mistake of the description and of the formulation; every doubt, where the request is
/// strict.
pub fn understand(description: &Description, request: &Request) -> Result<Chain, Errors> {
    check_processor(request)?;
    if let Err(refusal) = request.formulation.check() {
        let mut errors = Errors::new();
        errors.push_with_hint(Place::Unknown, refusal.message, refusal.hint);
        return Err(errors);
    }
    let mut chain = chain::build(description, request)?;
    if let Some(doubt) = forward::doubt(&chain, request) {
        if request.strict {
            let mut errors = chain.source.errors();
            errors.push(doubt.place, format!("{} (refused: strict)", doubt.message));
            return Err(errors);
        }
        chain.report.warnings.push(doubt);
    }
    Ok(chain)
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
            "choose f32 as the scalar, or another target",
        );
    }
    errors.into_result(())
}

/// Refuses a chain that is too long for code without loops.
///
/// # Errors
/// Where more joints move than anyone can want a page of code for.
pub fn check_size(chain: &Chain) -> Result<(), Errors> {
    const MOST: usize = 1000;
    let mut errors = chain.source.errors();
    let moving = chain.joints.len();
    if moving > MOST {
        errors.push_with_hint(
            Place::Unknown,
            format!("{moving} joints move, and functions are generated for at most {MOST}"),
            "choose a base and a tip, and path_only",
        );
    }
    errors.into_result(())
}

/// What becomes a Rust function: each item of the request for the tip, or for the robot as a
/// whole, and again for each further frame.
fn wanted(chain: &Chain, request: &Request) -> Vec<(Vec<Function>, usize)> {
    let mut wanted = Vec::new();
    for functions in request.items() {
        let of_a_frame = functions.iter().all(|function| function.of_a_frame());
        let frames = if of_a_frame { chain.frames.len() } else { 1 };
        wanted.extend((0..frames).map(|frame| (functions.clone(), frame)));
    }
    wanted
}

fn list(
    chain: &Chain,
    functions: Vec<Function>,
    frame: usize,
    request: &Request,
) -> Result<Listed, Errors> {
    let found = cheapest(
        request.processor,
        request.formulation,
        chain,
        &functions,
        frame,
        request.scalar,
    )?;
    let mut accuracy = accuracy_of(&found, chain, &functions, means(request));
    // What would be refused in f32 promises nothing there.
    if request.scalar == Real::Generic
        && forward::form(chain, &functions, Real::F32, request.formulation.forward).is_err()
    {
        let promised = accuracy.into_iter().map(|accuracy| match accuracy {
            solved @ Accuracy::Backward(..) => solved.without_single(UNDONE),
            other => other,
        });
        accuracy = promised.collect();
    }
    let program = found.program;
    let (mut mul, mut add) = (0, 0);
    for &function in &functions {
        let (more_mul, more_add) =
            model::dense(function, chain.joints.len(), chain.joints_to(frame));
        mul += more_mul;
        add += more_add;
    }
    let price = Price::of(&program)
        .beside_dense(mul, add)
        .on(request.processor, request.scalar);
    let of_a_frame = functions.iter().all(|function| function.of_a_frame());
    let further = of_a_frame && (frame > 0 || !chain.has_tip);
    let frame = further.then(|| chain.frames[frame].name.clone());
    Ok(Listed {
        functions,
        frame,
        program,
        price,
        accuracy,
    })
}

/// Why solutions have no bound in `f32`.
const UNDONE: &str = "no digit may be left";

/// What the programs of a request compute with.
fn means(request: &Request) -> Means {
    Means {
        scalar: request.scalar,
        trigonometry: match request.formulation.sines {
            Sines::Own => request.trigonometry,
            Sines::Platform => Trigonometry::Other,
        },
    }
}

/// What is promised of the results of a program: of all that are evaluated, and of each that solves
/// something.
fn accuracy_of(
    found: &Found,
    chain: &Chain,
    functions: &[Function],
    means: Means,
) -> Vec<Accuracy> {
    let parts = |functions: &[Function]| program_by(chain, functions, 0, found.layout, found.way);
    let solves = functions.iter().filter_map(|function| match function {
        Function::MassMatrixInverse => {
            let parts = parts(&[Function::MassMatrix]);
            Some(accuracy::of_inverse(chain, &parts, means))
        }
        Function::ForwardDynamics => Some(match found.way.forward {
            Forward::MassMatrix { refinements } => {
                let all = [
                    Function::MassMatrix,
                    Function::Bias,
                    Function::InverseDynamics,
                ];
                let parts = parts(&all[..if refinements == 0 { 2 } else { 3 }]);
                accuracy::of_accelerations(chain, &parts, refinements, means)
            }
            Forward::Articulated => accuracy::of_articulated(chain, found.layout, found.way, means),
        }),
        _ => None,
    });
    let evaluated = accuracy::of(chain, functions, &found.program, means);
    evaluated.into_iter().chain(solves).collect()
}
