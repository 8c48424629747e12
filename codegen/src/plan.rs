//! How each function is computed: the layout of the frames, the algorithm and the formulation, with the program that they give.
//!
//! In: a [`Chain`]. Out: a [`Plan`] for each function that is asked for, made once, or why the robot cannot have
//! it. Of programs that compute the same, `choice` takes the one that costs least; where something is solved for, of those
//! that are `accurate` enough by what has been `measured`. Bounds and checks take a plan and build no program again.

mod accurate;
mod choice;
mod forward;
mod identifiable;
mod measured;
mod program;
mod search;
mod solvable;
mod weighable;

pub(crate) use forward::doubts;
pub use forward::keeps_half;
pub use measured::Off;
pub use program::{Programs, Recursion, expressions_by, program_by};

use std::rc::Rc;

use crate::chain::Chain;
use crate::error::{Errors, Place};
use crate::function::Function;
use crate::layout::Layout;
use crate::list;
use crate::model::Way;
use crate::schedule::{Price, Program};
use crate::space::FrameId;
use choice::cheapest;

/// How some functions are computed together, of a frame of a chain.
pub struct Plan<'c> {
    /// The robot.
    pub chain: &'c Chain,
    /// What is computed, one function after the other.
    pub functions: Vec<Function>,
    /// The frame, where they are of one.
    pub frame: FrameId,
    /// Where the frames of the bodies stand.
    pub layout: Layout,
    /// The algorithm and the formulation.
    pub way: Way,
    /// The operations.
    pub program: Program,
    /// What they cost, beside dense products.
    pub price: Price,
    /// The error that was measured, where the algorithm was chosen by it.
    pub off: Off,
    /// Programs of the same chain that bounds are made of.
    pub programs: Rc<Programs<'c>>,
}

impl Plan<'_> {
    /// The link whose frame it is about, where that is not the tip.
    #[must_use]
    pub fn further_frame(&self) -> Option<&str> {
        let of_a_frame = self.functions.iter().all(|function| function.of_a_frame());
        let further = of_a_frame && (self.frame > FrameId::FIRST || !self.chain.has_tip);
        further.then(|| &*self.chain.frames[self.frame].name)
    }
}

/// Functions that are asked for together, of a frame, with their plan or why there is none.
pub struct Planned<'c> {
    /// Their names.
    pub name: String,
    /// The plan.
    pub plan: Result<Plan<'c>, Errors>,
}

/// How many joints code without loops can be wanted for.
const MOST: usize = 1000;

/// Refuses a chain that is too long for code without loops.
///
/// # Errors
/// Where more joints move than anyone can want a page of code for.
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

/// Plans what is asked for of a chain, one function after the other.
///
/// # Errors
/// Of a chain that is too long.
pub fn plans(chain: &Chain) -> Result<impl Iterator<Item = Planned<'_>>, Errors> {
    check_size(chain)?;
    let programs = Programs::of(chain);
    let wanted = wanted(chain).into_iter();
    Ok(wanted.map(move |(functions, frame)| {
        let names: Vec<&str> = functions.iter().map(|function| function.name()).collect();
        Planned {
            name: names.join("_and_"),
            plan: plan(&programs, functions, frame),
        }
    }))
}

/// What becomes a generated function: each item of the request for the tip, or for the robot as a whole, and again for each
/// further frame.
fn wanted(chain: &Chain) -> Vec<(Vec<Function>, FrameId)> {
    let mut wanted = Vec::new();
    for functions in chain.request.items(!chain.loops.is_empty()) {
        let of_a_frame = functions.iter().all(|function| function.of_a_frame());
        let frames = list::ids(if of_a_frame { chain.frames.len() } else { 1 });
        wanted.extend(frames.map(|frame| (functions.clone(), frame)));
    }
    wanted
}

/// The cheapest plan of some functions together.
///
/// # Errors
/// Where the robot cannot have them.
///
/// # Panics
/// Where a function of a frame is asked for and the chain has none.
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
        let (more_mul, more_add) = function.dense(chain.joints.len(), chain.joints_to(frame));
        mul += more_mul;
        add += more_add;
    }
    let price = Price::of(&found.program).beside_dense(mul, add);
    Ok(Plan {
        chain,
        functions,
        frame,
        layout: found.layout,
        way: found.way,
        price: price.on(request.processor, request.scalar),
        program: found.program,
        off: found.off,
        programs: Rc::clone(programs),
    })
}
