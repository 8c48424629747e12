//! The way through the house: from a description to everything that is printed for it.
//!
//! In: a description and a request. Out: a [`Listing`]. It only connects the stages: where they offer
//! more than one way, `choice` decides by count, and where something is solved for, between those that
//! are `accurate` enough by what has been `measured`.

mod about;
mod accurate;
mod batches;
mod choice;
mod closure;
mod data;
mod forward;
mod identifiable;
mod measured;
mod program;
mod review;
mod search;
mod solvable;
mod weighable;

pub use choice::{program, program_as, program_for};
pub use closure::settled;
use program::{equation_at_rest_by, equation_by};
pub use program::{expressions_by, program_by};

use std::cell::LazyCell;

use crate::accuracy::{self, Accuracy, Articulated, Means};
use crate::chain::{self, Chain};
use crate::check::{self, Check, Redundancy, is_fault, judge_base_parameters};
use crate::description::{Description, freed};
use crate::error::{Errors, Place};
use crate::formulation::{Forward, Sines};
use crate::function::{Function, Given, Truth};
use crate::list;
use crate::print::{About, LeftOut, Listed, Listing, Prepared};
use crate::real::{Real, Trigonometry};
use crate::request::Request;
use crate::schedule::Price;
use crate::space::FrameId;
use about::about;
use choice::cheapest;
use data::data;
use search::Found;

/// Expands a robot.
///
/// # Errors
/// Every mistake of the description and of the request.
pub fn expand(description: &Description, request: &Request) -> Result<Listing, Errors> {
    let (description, request) = &freed(description, request);
    let chain = understand(description, request)?;
    check_size(&chain)?;
    let (chain, base) = identify(chain, description, request);
    let check = Check::of(description, request, &chain)?;
    let mut errors = Errors::new();
    let mut functions = Vec::new();
    // Of all that a robot can have, what it cannot have is left out.
    let all = request.functions.is_empty();
    let without_frame = || chain.frames.is_empty().then(functions_of_a_frame);
    let mut left_out: Vec<LeftOut> = all.then(without_frame).flatten().into_iter().collect();
    for (wanted, frame) in wanted(&chain, request) {
        let names: Vec<&str> = wanted.iter().map(|function| function.name()).collect();
        let name = names.join("_and_");
        let identified = if wanted.contains(&Function::BaseRegressor) {
            base.clone()
        } else {
            Ok(())
        };
        let listed = identified.and_then(|()| list(&chain, wanted, frame, request));
        let judged = listed.and_then(|listed| {
            check.judge(&listed.functions, frame, &listed.program, request.scalar)?;
            Ok(listed)
        });
        match judged {
            Ok(listed) => functions.push(listed),
            Err(refusal) if all => leave_out(&mut left_out, name, &refusal),
            Err(refusal) => errors.append(refusal),
        }
    }
    let data = data(&chain);
    if let Err(refusal) = check.judge_data(&data) {
        errors.append(refusal);
    }
    let mut about = About {
        left_out,
        ..about(description, &chain, request.formulation)
    };
    if request.batch
        && let Err(refusal) = batches::tell(&functions, &chain, request, &mut about)
    {
        errors.append(refusal);
    }
    let listing = Listing {
        about,
        spaces: chain.spaces().clone(),
        review: request
            .review
            .then(|| review::review(description, request, &chain, &functions)),
        functions,
        data,
        base_values: base_values(&chain),
        batch: request.batch,
        length: request.length(),
        scalar: request.scalar,
        sines: request.formulation.sines,
        parameters: request.parameters.clone(),
        prepared: None,
    };
    if !request.prepare {
        return errors.into_result(listing);
    }
    let listing = listing.prepare(request.processor);
    let reads = |prepared: &Prepared| !prepared.names.is_empty();
    if errors.is_empty() && !listing.prepared.as_ref().is_some_and(reads) {
        errors.push_with_hint(
            Place::Unknown,
            "`prepare` computes once what depends on fields alone, and no function reads one",
            "leave it out, or ask for functions that read the fields",
        );
    }
    if let Err(fault) = check.judge_prepared(&listing) {
        errors.append(fault);
    }
    errors.into_result(listing)
}

/// The same chain, with its base parameters where a function of them is asked for, and why that cannot be had.
fn identify(
    chain: Chain,
    description: &Description,
    request: &Request,
) -> (Chain, Result<(), Errors>) {
    if !request.asks_for(Function::BaseRegressor) {
        return (chain, Ok(()));
    }
    let chain = chain.identified();
    let judged = judge_base_parameters(description, request, &chain);
    (chain, judged)
}

/// The same chain with its base parameters, held against the description.
///
/// # Errors
/// Where they cannot be told apart, or are wrong.
pub fn identified(
    chain: Chain,
    description: &Description,
    request: &Request,
) -> Result<Chain, Errors> {
    let chain = chain.identified();
    judge_base_parameters(description, request, &chain)?;
    Ok(chain)
}

/// Base parameters as described.
fn base_values(chain: &Chain) -> Vec<f64> {
    let groups = chain.base_parameters.iter().flat_map(|base| &base.groups);
    groups.map(|group| group.value).collect()
}

/// The functions that a robot cannot have whose frames nobody asks for.
fn functions_of_a_frame() -> LeftOut {
    let all = Function::ALL.into_iter();
    let of_a_frame = all.filter(|function| function.of_a_frame());
    LeftOut {
        functions: of_a_frame
            .map(|function| function.name().to_owned())
            .collect(),
        reason: "the robot has more than one end, and none is named as the tip".to_owned(),
        hint: Some("name a link as the tip, or further frames".to_owned()),
        is_fault: false,
    }
}

/// Notes a function that the robot cannot have, beside those that it cannot have for the same reason.
fn leave_out(left_out: &mut Vec<LeftOut>, function: String, refusal: &Errors) {
    let reasons = refusal.complaints().iter();
    let reasons: Vec<String> = reasons.map(|reason| refusal.locate(reason)).collect();
    let reason = reasons.join("; ");
    if let Some(same) = left_out.iter_mut().find(|other| other.reason == reason) {
        same.functions.push(function);
    } else {
        let mut hints = refusal.complaints().iter();
        left_out.push(LeftOut {
            functions: vec![function],
            reason,
            hint: hints.find_map(|complaint| complaint.hint.clone()),
            is_fault: is_fault(refusal),
        });
    }
}

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
    let mut doubts = forward::doubts(&chain, request);
    if solves_loops(&chain, request) {
        let Redundancy {
            dependent,
            warnings,
        } = check::redundancy(description, request, &chain);
        chain.report.dependent = dependent;
        doubts.extend(warnings);
    }
    if request.strict && !doubts.is_empty() {
        let mut errors = chain.source.errors();
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

/// How many joints code without loops can be wanted for.
const MOST: usize = 1000;

/// Refuses a chain that is too long for code without loops.
///
/// # Errors
/// Where more joints move than anyone can want a page of code for.
pub fn check_size(chain: &Chain) -> Result<(), Errors> {
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
fn wanted(chain: &Chain, request: &Request) -> Vec<(Vec<Function>, FrameId)> {
    let mut wanted = Vec::new();
    for functions in request.items(!chain.loops.is_empty()) {
        let of_a_frame = functions.iter().all(|function| function.of_a_frame());
        let frames = list::ids(if of_a_frame { chain.frames.len() } else { 1 });
        wanted.extend(frames.map(|frame| (functions.clone(), frame)));
    }
    wanted
}

fn list(
    chain: &Chain,
    functions: Vec<Function>,
    frame: FrameId,
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
    // What would be refused in f32, where it loses as many units, promises nothing there.
    if request.scalar == Real::Generic && !forward::keeps_half(found.off.worst, Real::F32) {
        let promised = accuracy.into_iter().map(|accuracy| match accuracy {
            solved @ (Accuracy::Backward(..) | Accuracy::BesideDiagonal(_)) => {
                solved.without_single(UNDONE)
            }
            other => other,
        });
        accuracy = promised.collect();
    }
    let program = found.program;
    let (mut mul, mut add) = (0, 0);
    for &function in &functions {
        let (more_mul, more_add) = function.dense(chain.joints.len(), chain.joints_to(frame));
        mul += more_mul;
        add += more_add;
    }
    let price = Price::of(&program)
        .beside_dense(mul, add)
        .on(request.processor, request.scalar);
    let of_a_frame = functions.iter().all(|function| function.of_a_frame());
    let further = of_a_frame && (frame > FrameId::FIRST || !chain.has_tip);
    let frame = further.then(|| chain.frames[frame].name.clone());
    Ok(Listed {
        functions,
        frame,
        layout: found.layout,
        program,
        price,
        accuracy,
    })
}

/// Why solutions have no bound in `f32`.
const UNDONE: &str = "less than half of the digits may be left";

/// What the programs of a request compute with.
pub(crate) fn means(request: &Request) -> Means {
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
    let parts = |functions: &[Function]| {
        program_by(chain, functions, FrameId::FIRST, found.layout, found.way)
    };
    let forward = found.way.forward;
    let has_residual = matches!(forward, Forward::MassMatrix { refinements: 1.. });
    let equation = LazyCell::new(|| equation_by(chain, found.layout, found.way, has_residual));
    let bodies = LazyCell::new(|| Articulated::of(chain, found.layout, found.way));
    let of_bodies = |promised: &dyn Fn(&Articulated<'_>) -> Accuracy| match &*bodies {
        Ok(bodies) => promised(bodies),
        Err(reason) => Accuracy::Unknown(reason),
    };
    let solution = |given: Given| match (given, forward) {
        (Given::Torques, Forward::MassMatrix { refinements }) => {
            accuracy::of_accelerations(chain, &equation, refinements, means)
        }
        (Given::Torques, Forward::Articulated) => of_bodies(&|bodies| bodies.accelerations(means)),
        (Given::MassMatrix, Forward::Articulated) => of_bodies(&|bodies| bodies.inverse(means)),
        (Given::TorqueDerivatives, Forward::Articulated) => {
            let derivatives = parts(&[Function::InverseDynamicsDerivatives]);
            of_bodies(&|bodies| bodies.derivatives(&derivatives, means))
        }
        (Given::MassMatrix, Forward::UNREFINED) => {
            accuracy::of_inverse(chain, &parts(&[Function::MassMatrix]), means)
        }
        (Given::MassMatrix, Forward::MassMatrix { refinements }) => {
            let at_rest = equation_at_rest_by(chain, found.layout, found.way);
            accuracy::of_refined_inverse(chain, &at_rest, refinements, means)
        }
        (Given::TorqueDerivatives, Forward::UNREFINED) => {
            let derivatives = parts(&[Function::InverseDynamicsDerivatives]);
            accuracy::of_derivatives(chain, &equation, &derivatives, means)
        }
        (Given::TorqueDerivatives, _) => {
            Accuracy::Unknown("none is derived of an inverse that is refined")
        }
    };
    // What several functions solve is said once.
    let mut said = Vec::new();
    let solved = functions.iter().flat_map(|function| {
        let Truth::Solution(given) = function.truth() else {
            let unknown = Accuracy::Unknown("none is derived where loops are held together");
            let held = function.is_constrained().then_some(unknown);
            return held.into_iter().collect::<Vec<_>>();
        };
        // Derivatives are of accelerations that are found, and M⁻¹ is one of them. Of what is made with an inverse no
        // more can be said than of that.
        let givens = match given {
            Given::TorqueDerivatives if !has_residual => {
                vec![Given::Torques, Given::TorqueDerivatives, Given::MassMatrix]
            }
            given => vec![given],
        };
        let new = givens.into_iter().filter(|given| !said.contains(given));
        let new: Vec<Given> = new.collect();
        said.extend(&new);
        new.into_iter().map(solution).collect()
    });
    let evaluated = accuracy::of(chain, functions, &found.program, means);
    evaluated.into_iter().chain(solved).collect()
}

#[cfg(test)]
mod long_chains;
#[cfg(test)]
mod tests;
