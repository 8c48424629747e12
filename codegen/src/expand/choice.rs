//! Which of the programs that compute the same is taken.
//!
//! In: a chain, the functions that are asked for together, a formulation. Out: the [`Program`] that
//! costs least on a processor, of all layouts of the frames and all ways that compute them, and of the
//! forms of forward dynamics that are accurate enough. It never looks at values itself: [`Measure`]
//! tells how far a program is off and what is enough, and [`forward`] which forms there are.

use super::forward::{self, Form};
use super::identifiable::settled;
use super::measured::{ENOUGH, Measure, Off};
use super::program::expressions_by;
use super::solvable::solvable;
use super::weighable::weighable;
use crate::chain::Chain;
use crate::error::{Errors, Place};
use crate::formulation::{Angles, Formulation, Forward, Frame, Parameters, Products};
use crate::function::Function;
use crate::layout::Layout;
use crate::model::Way;
use crate::processor::Processor;
use crate::real::Real;
use crate::schedule::{Price, Program, schedule, schedule_unfused};
use crate::space::FrameId;
use crate::wording::quoted;

/// The cheapest program found for some functions together, of a frame of the chain.
///
/// # Errors
/// Where forward dynamics, or the inverse of the mass matrix, is asked for of a chain that has none, or
/// that no form leaves half of the digits in this type of number; where a centre of mass is asked for of one
/// without mass.
///
/// # Panics
/// Where a function of a frame is asked for and the chain has none.
pub fn program(
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
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
    frame: FrameId,
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
    frame: FrameId,
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
    /// How far off it was measured to be, where the form was chosen by it.
    pub(super) off: Off,
}

/// A program that is not accurate enough, with its weight where all layouts have been looked at.
type Tried = (Option<usize>, Found);

pub(super) fn cheapest(
    processor: Processor,
    formulation: Formulation,
    chain: &Chain,
    functions: &[Function],
    frame: FrameId,
    scalar: Real,
) -> Result<Found, Errors> {
    if functions.iter().any(|function| function.is_of_mass()) {
        weighable(chain)?;
    }
    closable(chain, functions)?;
    if functions.contains(&Function::BaseRegressor) {
        settled(chain)?;
    }
    let search = Search::new(processor, formulation, chain, functions, frame, scalar);
    if !functions.iter().any(|function| function.solves()) {
        let inverts = |function: &Function| function.is_constrained() && !function.wants_drives();
        if functions.iter().any(inverts) {
            solvable(chain)?;
            return Ok(search.best(Form::full(Forward::UNREFINED)).1);
        }
        return Ok(search.best(Form::sparing(Forward::UNREFINED)).1);
    }
    let worst = solvable(chain)?;
    if let Some(asked) = formulation.forward {
        forward::check(chain, asked)?;
        return Ok(search.best(Form::sparing(asked)).1);
    }
    let mut measure = Measure::of(chain, functions, worst.loss);
    let mut measured = |mut found: Found| {
        found.off = measure.error(&found.program, scalar);
        found
    };
    let mut tried: Vec<Tried> = Vec::new();
    // Other layouts of forms that lose too much in their lightest one.
    let mut heavier: Vec<(usize, Found)> = Vec::new();
    let mut best: Option<(usize, Found)> = None;
    for forms in forward::rounds(chain, functions, formulation) {
        for form in forms {
            // Of a form that is far from accurate in one layout, no other need be looked at.
            if let Some((_, before)) = tried.first() {
                let (_, glimpse) = search.within(form, &[before.layout], &[before.way]);
                let glimpse = measured(glimpse);
                if glimpse.off.worst > FAR * ENOUGH {
                    tried.push((None, glimpse));
                    continue;
                }
            }
            let mut layouts = search.by_weight(form).into_iter();
            let (weight, found) = layouts.next().expect("there is at least one layout");
            if best.as_ref().is_some_and(|(least, _)| *least <= weight) {
                continue;
            }
            let found = measured(found);
            if found.off.worst <= ENOUGH {
                best = Some((weight, found));
            } else {
                tried.push((Some(weight), found));
                heavier.extend(layouts);
            }
        }
        if best.is_some() {
            break;
        }
    }
    // Where frames stand away from their bodies, that may be what costs the digits.
    if let Some((least, _)) = &best {
        heavier.retain(|(weight, _)| weight < least);
    }
    heavier.sort_by_key(|(weight, _)| *weight);
    let mut heavier = heavier.into_iter().map(|(_, found)| measured(found));
    let nearer = heavier.find(|found| found.off.worst <= ENOUGH);
    if let Some(found) = nearer.or(best.map(|(_, found)| found)) {
        return Ok(found);
    }
    // None is accurate enough.
    let least = (tried.iter()).fold(Off::INFINITE, |least, (_, found)| least.least(found.off));
    if !forward::keeps_half(least.eighth, scalar) {
        return Err(forward::hopeless(
            chain,
            worst,
            least.worst,
            functions,
            (scalar, formulation.frame),
        ));
    }
    let searched = nearly_as_good(tried, least.worst).into_iter();
    let searched = searched.map(|(weight, found)| {
        if let Some(weight) = weight {
            return (weight, found);
        }
        let (weight, found) = search.best(Form::of(found.way));
        (weight, measured(found))
    });
    let best = searched.min_by_key(|(weight, _)| *weight);
    Ok(best.expect("the least is among them").1)
}

/// Those that lose little more than the best, where none is accurate enough. What is lost near singular postures
/// is lost by all, and a few times more of it is less than an inverse that does not invert.
fn nearly_as_good(mut tried: Vec<Tried>, least: f64) -> Vec<Tried> {
    let solves = |found: &Found| found.off.worst <= FAR * least && found.off.unsolved <= ENOUGH;
    if tried.iter().any(|(_, found)| solves(found)) {
        tried.retain(|(_, found)| solves(found));
    }
    let worst = tried.iter().map(|(_, found)| found.off.worst);
    let least = worst.fold(f64::INFINITY, f64::min);
    tried.retain(|(_, found)| found.off.worst <= 2.0 * least);
    tried
}

/// Refuses what is of loops where there are none.
fn closable(chain: &Chain, functions: &[Function]) -> Result<(), Errors> {
    let mut errors = chain.source.errors();
    let of_loops = functions.iter().filter(|function| function.is_of_loops());
    for function in of_loops.filter(|_| chain.loops.is_empty()) {
        let name = quoted(function.name());
        errors.push_with_hint(
            Place::Unknown,
            format!("{name} is of robots with loops, and this one has none"),
            "close one: loop pin: revolute(z) { from: coupler, to: rocker, at: xyz(0.1, 0, 0) }",
        );
    }
    if let Some(function) = functions.iter().find(|function| function.wants_drives())
        && !chain.actuated.contains(&true)
    {
        let name = quoted(function.name());
        let message = format!("{name} asks which joints are driven");
        errors.push_with_hint(Place::Unknown, message, "name them: actuated(crank)");
    }
    errors.into_result(())
}

/// How many times the error that is enough is far from it.
const FAR: f64 = 16.0;

/// Where the program of least weight is looked for.
struct Search<'a> {
    processor: Processor,
    formulation: Formulation,
    chain: &'a Chain,
    functions: &'a [Function],
    frame: FrameId,
    scalar: Real,
    layouts: Vec<Layout>,
    ways: Vec<Way>,
}

impl<'a> Search<'a> {
    fn new(
        processor: Processor,
        formulation: Formulation,
        chain: &'a Chain,
        functions: &'a [Function],
        frame: FrameId,
        scalar: Real,
    ) -> Self {
        let dynamic = functions.iter().any(|function| !function.of_a_frame());
        Self {
            processor,
            formulation,
            chain,
            functions,
            frame,
            scalar,
            layouts: if dynamic {
                Layout::for_dynamics(chain)
            } else {
                Layout::for_kinematics(chain)
            },
            ways: ways(formulation, functions),
        }
    }

    /// The program of least weight in a form of forward dynamics, of all layouts and ways; its error has
    /// not been measured.
    fn best(&self, form: Form) -> (usize, Found) {
        self.within(form, &self.layouts, &self.ways)
    }

    /// That of each layout, the lightest first.
    fn by_weight(&self, form: Form) -> Vec<(usize, Found)> {
        let layouts = self.layouts.chunks(1);
        let mut found: Vec<_> = layouts
            .map(|layout| self.within(form, layout, &self.ways))
            .collect();
        found.sort_by_key(|(weight, _)| *weight);
        found
    }

    /// The same as [`best`](Self::best), of some layouts and ways.
    fn within(&self, form: Form, layouts: &[Layout], ways: &[Way]) -> (usize, Found) {
        let schedule = match self.formulation.products {
            Products::Fused if self.processor.fuses(self.scalar) => schedule,
            Products::Fused | Products::Unfused => schedule_unfused,
        };
        // What a body opposes to an acceleration must be a body's; and a refinement is as good as its
        // residual: a literal that has taken in a heavy neighbour's mass is rounded to the size of
        // that.
        let physical =
            form.forward != Forward::UNREFINED || self.formulation.parameters == Parameters::Raw;
        let mut best: Option<(usize, Found)> = None;
        for &layout in layouts {
            let regroup = layout.regroup && !physical;
            let layout = Layout { regroup, ..layout };
            for &way in ways {
                let scalar = self.scalar;
                let way = Way {
                    scalar,
                    ..form.along(way)
                };
                let (chain, functions) = (self.chain, self.functions);
                let (graph, results) = expressions_by(chain, functions, self.frame, layout, way);
                let program = schedule(&graph, &results);
                let weight = Price::of(&program).weight(self.processor, self.scalar);
                if best.as_ref().is_none_or(|(least, _)| weight < *least) {
                    let found = Found {
                        program,
                        layout,
                        way,
                        off: Off::NONE,
                    };
                    best = Some((weight, found));
                }
            }
        }
        best.expect("there is at least one layout and one way")
    }
}

/// The ways between which the count decides.
fn ways(formulation: Formulation, functions: &[Function]) -> Vec<Way> {
    let apart = match formulation.frame {
        Frame::Link => functions
            .iter()
            .map(|&function| function.ways())
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
