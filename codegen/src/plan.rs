//! Planning: the layout of frames, the algorithm and the formulation of each function, with the program.
//!
//! In: a [`Chain`]. Out: a [`Plan`] for each requested function, made once, or the reason why the robot cannot have
//! it. Of programs that compute the same, `choice` takes the cheapest; for a function that solves an equation, the
//! cheapest of those that are `accurate` enough by the `measured` error. Bounds and checks take a plan and build no
//! program again.

mod accurate;
mod choice;
mod forward;
mod identifiable;
mod inertial_parameters;
mod measured;
mod program;
mod search;
mod solvable;
mod weighable;

pub use forward::keeps_half;
pub(crate) use forward::warnings;
pub use inertial_parameters::inertial_parameters;
pub use measured::MeasuredError;
pub use program::{Programs, Recursion, arranged, expressions_by, program_by};

use std::rc::Rc;

use crate::chain::Chain;
use crate::error::{Errors, Place};
use crate::function::Function;
use crate::layout::Layout;
use crate::list;
use crate::model::Algorithm;
use crate::schedule::{OperationCount, Program, fused_alike};
use crate::space::FrameId;
use choice::cheapest;

/// The computation of some functions together, for a frame of a chain.
pub struct Plan<'c> {
    /// The robot.
    pub chain: &'c Chain,
    /// The functions, in the order of computation.
    pub functions: Vec<Function>,
    /// The frame, for functions of a frame.
    pub frame: FrameId,
    /// The layout of the frames of bodies.
    pub layout: Layout,
    /// The algorithm and the formulation.
    pub algorithm: Algorithm,
    /// The operations.
    pub program: Program,
    /// Their operation count, with that of dense products.
    pub operation_count: OperationCount,
    /// The measured error, if the algorithm was chosen by it.
    pub error: MeasuredError,
    /// Programs of the same chain, from which bounds are made.
    pub programs: Rc<Programs<'c>>,
}

impl Plan<'_> {
    /// The link of its frame, if that is not the tip.
    #[must_use]
    pub fn further_frame(&self) -> Option<&str> {
        let of_a_frame = self.functions.iter().all(|function| function.of_a_frame());
        let further = of_a_frame && (self.frame > FrameId::FIRST || !self.chain.has_tip);
        further.then(|| &*self.chain.frames[self.frame].name)
    }
}

/// Functions that are requested together, for a frame, with their plan or the errors.
pub struct Planned<'c> {
    /// Their names.
    pub name: String,
    /// The plan.
    pub plan: Result<Plan<'c>, Errors>,
}

/// Largest number of joints that straight-line code is generated for.
const MOST: usize = 1000;

/// Rejects a chain that is too long for straight-line code.
///
/// # Errors
/// If more than 1000 joints move.
pub fn check_size(chain: &Chain) -> Result<(), Errors> {
    let mut errors = chain.description.source.errors();
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

/// Plans the requested functions of a chain, one after the other.
///
/// # Errors
/// If the chain is too long.
pub fn plans(chain: &Chain) -> Result<impl Iterator<Item = Planned<'_>>, Errors> {
    check_size(chain)?;
    let programs = Programs::of(chain);
    let wanted = wanted(chain).into_iter();
    Ok(wanted.map(move |(functions, frame)| planned(&programs, functions, frame)))
}

/// Plans some functions together, for a frame.
///
/// # Panics
/// If a function of a frame is requested and the chain has none.
pub fn planned<'c>(
    programs: &Rc<Programs<'c>>,
    functions: Vec<Function>,
    frame: FrameId,
) -> Planned<'c> {
    let names: Vec<&str> = functions.iter().map(|function| function.name()).collect();
    Planned {
        name: names.join("_and_"),
        plan: plan(programs, functions, frame),
    }
}

/// The functions to generate: each item of the request for the tip, or for the robot as a whole, and again for each
/// further frame.
#[must_use]
pub fn wanted(chain: &Chain) -> Vec<(Vec<Function>, FrameId)> {
    let mut wanted = Vec::new();
    for functions in chain.request.items(!chain.loops.is_empty()) {
        let each = functions.iter().all(|function| function.of_a_frame());
        let some = functions.iter().any(|function| function.needs_a_frame());
        let frames = list::ids(match chain.frames.len() {
            count if each => count,
            0 if some => 0,
            _ => 1,
        });
        wanted.extend(frames.map(|frame| (functions.clone(), frame)));
    }
    wanted
}

/// The cheapest plan of some functions together.
///
/// # Errors
/// If the robot cannot have them.
///
/// # Panics
/// If a function of a frame is requested and the chain has none.
pub fn plan<'c>(
    programs: &Rc<Programs<'c>>,
    functions: Vec<Function>,
    frame: FrameId,
) -> Result<Plan<'c>, Errors> {
    let chain = programs.chain();
    let request = &chain.request;
    let found = cheapest(
        request.processor,
        request.formulation,
        chain,
        &functions,
        frame,
        request.scalar,
    )?;
    let (mut mul, mut add) = (0, 0);
    for &function in &functions {
        let (joints, path) = (chain.joints.len(), chain.joints_to(frame));
        let (more_mul, more_add) = function.dense(joints, path, chain.spaces());
        mul += more_mul;
        add += more_add;
    }
    let program = fused_alike(found.program, &chain.spaces().limbs);
    let operation_count = OperationCount::of(&program).beside_dense(mul, add);
    Ok(Plan {
        chain,
        functions,
        frame,
        layout: found.layout,
        algorithm: found.algorithm,
        operation_count: operation_count.on(request.processor, request.scalar),
        program,
        error: found.error,
        programs: Rc::clone(programs),
    })
}
