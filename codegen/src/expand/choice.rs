//! Which of the programs that compute the same is taken.
//!
//! In: a chain, the functions that are asked for together, a formulation. Out: the [`Program`] that
//! costs least on a processor, of all layouts of the frames and all ways that compute them; or the
//! program of one layout and one way. It never looks at values: which form of forward dynamics is
//! accurate enough has been decided in [`forward`].

use super::forward;
use crate::chain::Chain;
use crate::chain::frames::{Layout, arrange};
use crate::error::Errors;
use crate::expression::{Expr, Graph, Term};
use crate::formulation::{Angles, Formulation, Forward, Frame, Parameters, Products};
use crate::function::Function;
use crate::model::{self, Way};
use crate::request::Real;
use crate::schedule::{Price, Program, schedule, schedule_unfused};
use crate::simplify::simplify;
use crate::target::Processor;

/// The cheapest program found for some functions together, of a frame of the chain.
///
/// # Errors
/// Where forward dynamics is asked for of a chain that has none, or that would have no correct
/// digit in this type of number.
///
/// # Panics
/// Where a function of a frame is asked for and the chain has none.
pub fn program(
    chain: &Chain,
    functions: &[Function],
    frame: usize,
    scalar: Real,
) -> Result<Program, Errors> {
    program_as(Formulation::default(), chain, functions, frame, scalar)
}

/// The cheapest program found within a formulation.
///
/// # Errors
/// As [`program`]; but a form of forward dynamics that is asked for is refused only where there is
/// no forward dynamics at all.
///
/// # Panics
/// As [`program`] does.
pub fn program_as(
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    frame: usize,
    scalar: Real,
) -> Result<Program, Errors> {
    let processor = Processor::Portable;
    program_for(processor, formulation, chain, functions, frame, scalar)
}

/// The program that is cheapest on a processor, within a formulation.
///
/// # Errors
/// As [`program_as`].
///
/// # Panics
/// As [`program`] does.
pub fn program_for(
    processor: Processor,
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    frame: usize,
    scalar: Real,
) -> Result<Program, Errors> {
    let found = cheapest(processor, formulation, chain, functions, frame, scalar)?;
    Ok(found.program)
}

/// A program, and how it came about.
pub(super) struct Found {
    pub(super) program: Program,
    pub(super) layout: Layout,
    pub(super) way: Way,
}

pub(super) fn cheapest(
    processor: Processor,
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    frame: usize,
    scalar: Real,
) -> Result<Found, Errors> {
    let forms = forms(formulation, chain, functions, scalar)?;
    let dynamic = functions.iter().any(|function| !function.of_a_frame());
    let layouts = if dynamic {
        Layout::for_dynamics(chain)
    } else {
        Layout::for_kinematics(chain)
    };
    let schedule = match formulation.products {
        Products::Fused if processor.fuses(scalar) => schedule,
        Products::Fused | Products::Unfused => schedule_unfused,
    };
    let ways = ways(formulation, functions);
    let mut best: Option<(usize, Found)> = None;
    for forward in forms {
        // What a body opposes to an acceleration must be a body's; and a refinement is as good as its
        // residual: a literal that has taken in a heavy neighbour's mass is rounded to the size of
        // that.
        let physical = forward != Forward::UNREFINED || formulation.parameters == Parameters::Raw;
        for &layout in &layouts {
            let regroup = layout.regroup && !physical;
            let layout = Layout { regroup, ..layout };
            for &way in &ways {
                let way = Way { forward, ..way };
                let (graph, results) = expressions_by(chain, functions, frame, layout, way);
                let program = schedule(&graph, &results);
                let weight = processor.weight(scalar, &Price::of(&program));
                if best.as_ref().is_none_or(|(least, _)| weight < *least) {
                    let found = Found {
                        program,
                        layout,
                        way,
                    };
                    best = Some((weight, found));
                }
            }
        }
    }
    Ok(best
        .expect("there is at least one form, one layout and one way")
        .1)
}

/// The forms of forward dynamics between which the count decides: the one that is accurate enough,
/// and articulated bodies for a chain so long that they may be cheaper. They lose fewer digits than
/// factors that need no refinement.
fn forms(
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    scalar: Real,
) -> Result<Vec<Forward>, Errors> {
    // The factors cost ever more for each further joint: with skew axes they are dearer from 11 on,
    // with right angles from 13. In a plane they are from 4 on, but an arm keeps the form that has the
    // closer error bound, and is expanded in half of the time.
    const COMPARED: usize = 8;
    const DEARER: usize = 20;
    let form = forward::form(chain, functions, scalar, formulation.forward)?;
    let articulated = Formulation {
        forward: Some(Forward::Articulated),
        ..formulation
    };
    let open = formulation.forward.is_none()
        && form == Forward::UNREFINED
        && functions.contains(&Function::ForwardDynamics)
        && articulated.check().is_ok();
    Ok(match longest(chain) {
        DEARER.. if open => vec![Forward::Articulated],
        COMPARED.. if open => vec![form, Forward::Articulated],
        _ => vec![form],
    })
}

/// The most joints that stand in a row.
fn longest(chain: &Chain) -> usize {
    let mut before: Vec<usize> = Vec::with_capacity(chain.joints.len());
    for joint in &chain.joints {
        before.push(1 + joint.parent.map_or(0, |parent| before[parent]));
    }
    before.into_iter().max().unwrap_or(0)
}

/// The ways between which the count decides.
fn ways(formulation: Formulation, functions: &[Function]) -> Vec<Way> {
    let apart = match formulation.frame {
        Frame::Link => functions
            .iter()
            .map(|&function| Way::all(function))
            .max_by_key(Vec::len)
            .unwrap_or_default(),
        Frame::Base => vec![Way::IN_FRAME_0],
    };
    match formulation.angles {
        Angles::Apart => apart,
        Angles::Merged => {
            let merged = apart.iter().map(|&way| Way {
                angles: Angles::Merged,
                ..way
            });
            merged.chain(apart.iter().copied()).collect()
        }
    }
}

/// The program that a layout and a way give.
#[must_use]
pub fn program_by(
    chain: &Chain,
    functions: &[Function],
    frame: usize,
    layout: Layout,
    way: Way,
) -> Program {
    let (graph, results) = expressions_by(chain, functions, frame, layout, way);
    schedule(&graph, &results)
}

/// What that program computes, with all its numbers as they came about.
#[must_use]
pub fn expressions_by(
    chain: &Chain,
    functions: &[Function],
    frame: usize,
    layout: Layout,
    way: Way,
) -> (Graph, Vec<Expr>) {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, layout);
    let results: Vec<Expr> = (functions.iter())
        .flat_map(|&function| model::build(&graph, &bodies, function, frame, way))
        .map(Term::expr)
        .collect();
    simplify(&graph, &results)
}
