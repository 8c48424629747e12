//! The way through the house: from a description to everything that is printed for it.
//!
//! In: a description, a request, the struct that gets the functions. Out: a [`Listing`]. It only
//! connects the stages, and chooses by count where they offer more than one way.

mod forward;

use crate::accuracy::{self, Accuracy};
use crate::chain::frames::{Layout, arrange};
use crate::chain::{self, Chain};
use crate::description::Description;
use crate::emit::{About, ChainData, Item, Listed, Listing};
use crate::error::{Errors, Place};
use crate::expression::{Double, Expr, Graph, Input, Node, Term};
use crate::formulation::{Angles, Formulation, Forward, Frame, Parameters, Products};
use crate::function::Function;
use crate::model::{self, Way};
use crate::request::{Real, Request};
use crate::schedule::{Price, Program, schedule, schedule_unfused};
use crate::simplify::simplify;
use crate::target::Processor;

/// Expands a robot.
///
/// # Errors
/// Every mistake of the description and of the request.
pub fn expand(description: &Description, request: &Request, item: Item) -> Result<Listing, Errors> {
    let chain = understand(description, request)?;
    check_size(&chain)?;
    let mut errors = Errors::new();
    let mut functions = Vec::new();
    for (wanted, frame) in wanted(&chain, request) {
        match list(&chain, wanted, frame, request) {
            Ok(listed) => functions.push(listed),
            // Of all that a robot can have, what it cannot have is left out.
            Err(_) if request.functions.is_empty() => {}
            Err(refusal) => errors.append(refusal),
        }
    }
    errors.into_result(Listing {
        item,
        about: about(description, &chain, request.formulation),
        functions,
        data: data(&chain),
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
struct Found {
    program: Program,
    layout: Layout,
    way: Way,
}

fn cheapest(
    processor: Processor,
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    frame: usize,
    scalar: Real,
) -> Result<Found, Errors> {
    let forward = forward::form(chain, functions, scalar, formulation.forward)?;
    let dynamic = functions.iter().any(|function| !function.of_a_frame());
    let layouts = if dynamic {
        Layout::for_dynamics(chain)
    } else {
        Layout::for_kinematics(chain)
    };
    // What a body opposes to an acceleration must be a body's; and a refinement is as good as its
    // residual: a literal that has taken in a heavy neighbour's mass is rounded to the size of that.
    let physical = !matches!(forward, Forward::MassMatrix { refinements: 0 })
        || formulation.parameters == Parameters::Raw;
    let schedule = match formulation.products {
        Products::Fused if processor.fuses(scalar) => schedule,
        Products::Fused | Products::Unfused => schedule_unfused,
    };
    let ways = ways(formulation, functions);
    let mut best: Option<(usize, Found)> = None;
    for layout in layouts {
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
    Ok(best.expect("there is at least one layout and one way").1)
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
    let accuracy = accuracy_of(&found, chain, &functions, request.scalar);
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

/// What is promised of the results of a program: of all that are evaluated, and of each that solves
/// something.
fn accuracy_of(
    found: &Found,
    chain: &Chain,
    functions: &[Function],
    scalar: Real,
) -> Vec<Accuracy> {
    let parts = |functions: &[Function]| program_by(chain, functions, 0, found.layout, found.way);
    let solves = functions.iter().filter_map(|function| match function {
        Function::MassMatrixInverse => {
            let parts = parts(&[Function::MassMatrix]);
            Some(accuracy::of_inverse(chain, &parts, scalar))
        }
        Function::ForwardDynamics => Some(match found.way.forward {
            Forward::MassMatrix { refinements } => {
                let all = [
                    Function::MassMatrix,
                    Function::Bias,
                    Function::InverseDynamics,
                ];
                let parts = parts(&all[..if refinements == 0 { 2 } else { 3 }]);
                accuracy::of_accelerations(chain, &parts, refinements, scalar)
            }
            Forward::Articulated => {
                Accuracy::Unknown("none is known of articulated bodies that holds for every state")
            }
        }),
        _ => None,
    });
    let evaluated = accuracy::of(chain, functions, &found.program, scalar);
    evaluated.into_iter().chain(solves).collect()
}

/// The chain as data: numbers, and sums of run-time parameters.
fn data(chain: &Chain) -> ChainData {
    let narrow = |k: usize| u16::try_from(k).expect("fewer than 65536 joints");
    let mut results: Vec<Expr> = Vec::new();
    for joint in &chain.joints {
        results.extend(joint.placement.entries());
        results.extend(chain.screw(joint).map(Term::expr));
        results.extend(joint.inertia.entries());
    }
    for frame in &chain.frames {
        results.extend(frame.placement.entries());
    }
    results.extend(chain.gravity.0);
    ChainData {
        names: chain
            .joints
            .iter()
            .map(|joint| joint.name.clone())
            .collect(),
        parents: chain
            .joints
            .iter()
            .map(|joint| joint.parent.map(narrow))
            .collect(),
        frames: chain
            .frames
            .iter()
            .map(|frame| (frame.name.clone(), frame.body.map(narrow)))
            .collect(),
        program: schedule(&chain.graph, &results),
    }
}

/// What the doc comments say of the robot.
fn about(description: &Description, chain: &Chain, formulation: Formulation) -> About {
    let source = &description.source;
    let report = &chain.report;
    About {
        robot: description.name.text.clone(),
        source: source.file.as_ref().map(|file| (file.clone(), source.hash)),
        base: report.base.clone(),
        tip: match chain.frames.first() {
            Some(tip) if chain.has_tip => tip.name.clone(),
            _ => String::new(),
        },
        joints: chain
            .joints
            .iter()
            .map(|joint| joint.name.clone())
            .collect(),
        facts: facts(chain, formulation.parameters),
        formulation: formulation.words(),
        warnings: warnings(description, chain),
    }
}

fn warnings(description: &Description, chain: &Chain) -> Vec<String> {
    let mut places = Errors::new();
    if let Some(file) = &description.source.file {
        places.set_file(file.clone(), None);
    }
    chain
        .report
        .warnings
        .iter()
        .map(|warning| places.locate(warning))
        .collect()
}

fn facts(chain: &Chain, parameters: Parameters) -> Vec<String> {
    let report = &chain.report;
    let mut facts = Vec::new();
    let mut count = |number: usize, one: &str, many: &str| match number {
        0 => {}
        1 => facts.push(format!("1 {one}")),
        _ => facts.push(format!("{number} {many}")),
    };
    count(report.merged.len(), "link merged", "links merged");
    count(report.locked.len(), "joint locked", "joints locked");
    count(report.dropped.len(), "link left out", "links left out");
    count(
        report.snapped.len(),
        "angle taken for a right angle",
        "angles taken for right angles",
    );
    facts.push(gravity(chain));
    let used = inertial_parameters(chain, parameters);
    facts.push(format!(
        "{used} of {} inertial parameters used",
        10 * chain.joints.len()
    ));
    facts
}

fn gravity(chain: &Chain) -> String {
    let entries = chain
        .gravity
        .map(|entry| chain.graph.value(entry).map(Double::to_f64));
    match entries.0 {
        [Some(x), Some(y), Some(z)] => {
            let names = ["x", "y", "z"];
            let along: Vec<(usize, f64)> = [x, y, z]
                .into_iter()
                .enumerate()
                .filter(|(_, entry)| *entry != 0.0)
                .collect();
            match along[..] {
                [] => "no gravity".into(),
                [(k, entry)] => {
                    let sign = if entry < 0.0 { "−" } else { "" };
                    format!(
                        "gravity only along {sign}{} ({} m/s²)",
                        names[k],
                        entry.abs()
                    )
                }
                _ => format!("gravity ({x}, {y}, {z}) m/s²"),
            }
        }
        _ => "gravity given at run time".into(),
    }
}

/// How many inertial parameters inverse dynamics reads, of those of the description or of those that
/// regrouping leaves.
fn inertial_parameters(chain: &Chain, parameters: Parameters) -> usize {
    let graph = chain.graph.clone();
    let layout = Layout {
        regroup: parameters == Parameters::Regrouped,
        ..Layout::DESCRIBED
    };
    let mut bodies = arrange(&graph, chain, layout);
    // Each becomes an input of its own, beyond those of struct fields, to be found among what is read.
    let fields = chain.nominal.len();
    for (body, field) in bodies.bodies.iter_mut().zip(fields..) {
        let field = u16::try_from(field).expect("fewer than 65536 joints and fields");
        let mut entries = 0..;
        body.inertia = body.inertia.map(|entry| match entries.next() {
            Some(k) if !entry.is_zero() => graph.input(Input::Parameter(field, k)),
            _ => entry,
        });
    }
    let torques = model::build(&graph, &bodies, Function::InverseDynamics, 0, Way::PLAIN);
    let torques: Vec<Expr> = torques.into_iter().map(Term::expr).collect();
    let (needed, _) = graph.needed(&torques);
    let is_read = |expr: &Expr| match graph.node(*expr) {
        Node::Input(Input::Parameter(field, _)) => usize::from(field) >= fields,
        _ => false,
    };
    needed.iter().filter(|expr| is_read(expr)).count()
}
