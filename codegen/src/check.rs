//! Every expansion is checked before it is printed.
//!
//! In: a description, what was asked for of it, and the programs that are to be printed. Out: nothing,
//! or a mistake that names function, entry and both numbers. The programs are run at a few states, in
//! 106 bits, against products of 4×4 matrices of the description as it was written: no merging, no
//! layout, no regrouping, no rules, no schedule. What they may differ by is what the rounding of their
//! literals to `f64` explains. It never changes a program.

mod base_parameters;
mod closing;
mod data;
mod redundancy;
mod robot;
mod solved;
mod states;
#[cfg(test)]
mod tests;
#[cfg(feature = "files")]
mod vectors;

use crate::chain::Chain;
use crate::dense::{Approximate, Dense, State};
use crate::description::Source;
use crate::error::{Errors, Place};
use crate::expression::{Arithmetic, Input};
use crate::function::{Function, Given, Truth};
use crate::list;
use crate::module::{ChainData, Module};
use crate::plan::Planned;
use crate::real::Real;
use crate::schedule::{Operand, Program, run};
use crate::space::{Entity, FrameId, Outcome, Quantity, Space, Spaces};
use crate::wording::quoted;
pub use base_parameters::judge_base_parameters;
pub use redundancy::{Redundancy, redundancy};
use robot::Contradiction;
#[cfg(feature = "files")]
pub use vectors::vectors;

/// A robot at a few states, by which programs are judged.
pub struct Check {
    source: Source,
    place: Place,
    spaces: Spaces,
    states: Vec<Dense>,
    /// Why its base parameters cannot be had.
    base_parameters: Result<(), Errors>,
}

/// At how many states a robot of so many joints is looked at: beyond, one has to do, and takes as long.
const SEVERAL: usize = 20;

/// How a robot is at fault where it contradicts itself.
const FAULT: &str =
    "this is a fault of homogen and not of the description: please report it, with the description";

/// Whether what was refused is at fault, and not what was described or asked for.
#[must_use]
pub fn is_fault(refusal: &Errors) -> bool {
    let mut hints = refusal
        .complaints()
        .iter()
        .map(|complaint| complaint.hint.as_deref());
    hints.any(|hint| hint == Some(FAULT))
}

/// A refusal that is a fault, for tests of what becomes of one.
#[cfg(test)]
pub(crate) fn fault(message: &str) -> Errors {
    let mut errors = Errors::new();
    errors.push_with_hint(Place::Unknown, message, FAULT);
    errors
}

impl Check {
    /// Computes what the description says of a chain.
    ///
    /// # Errors
    /// Where they do not agree on which joints move, or on what a number was taken for.
    pub fn of(chain: &Chain) -> Result<Self, Errors> {
        let place = chain.description.name.place;
        let count = if chain.joints.len() > SEVERAL { 1 } else { 2 };
        let at = |state: &State| {
            let robot = robot::robot(chain, &state.fields)?;
            Ok(Dense::of(robot, state.clone()))
        };
        let states = || {
            let mut states = states::states(chain, count);
            // The equations of the loops hold in every state; where some depend on others, only in closed ones.
            if let [_, second] = &mut *states
                && let Some(closed) = states::closed(chain, 1, at)?
            {
                *second = closed;
            }
            states.iter().map(at).collect()
        };
        let states: Result<Vec<Dense>, Contradiction> = states();
        match states {
            Ok(states) => Ok(Self {
                source: chain.description.source.clone(),
                place,
                spaces: chain.spaces().clone(),
                states,
                base_parameters: judge_base_parameters(chain),
            }),
            Err(Contradiction(what)) => {
                let mut errors = chain.description.source.errors();
                let message = format!("chain and description disagree: {what}");
                errors.push_with_hint(place, message, FAULT);
                Err(errors)
            }
        }
    }

    /// Holds a plan against the description; where it is refused, that stands in its place.
    #[must_use]
    pub fn judge<'c>(&self, planned: Planned<'c>, scalar: Real) -> Planned<'c> {
        let judged = planned.plan.and_then(|plan| {
            self.judge_program(&plan.functions, plan.frame, &plan.program, scalar)?;
            Ok(plan)
        });
        Planned {
            plan: judged,
            ..planned
        }
    }

    /// Holds what a module has beside its functions against the description: the robot as data, and what is computed once.
    ///
    /// # Errors
    /// Where one of them is another.
    pub fn judge_module(&self, module: &Module) -> Result<(), Errors> {
        let mut errors = Errors::new();
        for judged in [self.judge_data(&module.data), self.judge_prepared(module)] {
            if let Err(refusal) = judged {
                errors.append(refusal);
            }
        }
        errors.into_result(())
    }

    /// Holds a program that computes some functions one after the other, of that frame,
    /// against the description.
    ///
    /// # Errors
    /// Where a result is another one, or where a number of the program is not one in the type that it is
    /// printed for.
    pub fn judge_program(
        &self,
        functions: &[Function],
        frame: FrameId,
        program: &Program,
        scalar: Real,
    ) -> Result<(), Errors> {
        if functions.contains(&Function::BaseRegressor) {
            self.base_parameters.clone()?;
        }
        self.printable(program, scalar)?;
        let mut errors = self.source.errors();
        for dense in &self.states {
            let found = run(program, |input| Approximate::exact(dense.state.get(input)));
            let mut found = found.as_slice();
            for &function in functions {
                let (these, rest) = found.split_at(function.result().size(&self.spaces));
                found = rest;
                let Some(wrong) = first_wrong(dense, function, (frame, scalar), these) else {
                    continue;
                };
                errors.push_with_hint(self.place, self.words(function, &wrong), FAULT);
                return Err(errors);
            }
        }
        Ok(())
    }

    /// Holds what is left of functions whose part of fields alone is computed once against the whole of them:
    /// bit for bit.
    ///
    /// # Errors
    /// Where a result is another one.
    fn judge_prepared(&self, listing: &Module) -> Result<(), Errors> {
        let mut errors = self.source.errors();
        let Some(prepared) = &listing.prepared else {
            return Ok(());
        };
        for dense in &self.states {
            let state = |input| dense.state.get(input).to_f64();
            let values = run(&prepared.once, state);
            let either = |input| match input {
                Input::Parameter(_, value) => values[usize::from(value)],
                Input::Variable(..) => state(input),
            };
            for (whole, left) in listing.functions.iter().zip(&prepared.functions) {
                let bits = |results: Vec<f64>| -> Vec<u64> {
                    results.into_iter().map(f64::to_bits).collect()
                };
                if bits(run(&whole.program, state)) != bits(run(&left.program, either)) {
                    let message = format!("{} would be another once prepared", whole.name());
                    errors.push_with_hint(self.place, message, FAULT);
                    return Err(errors);
                }
            }
        }
        Ok(())
    }

    /// Holds the robot as data against the description: its frames, the torques of its motion, and the
    /// residuals of its loops with what changes them.
    ///
    /// # Errors
    /// Where one of them is another, or where a number is not one.
    pub(crate) fn judge_data(&self, data: &ChainData) -> Result<(), Errors> {
        for program in [&data.program, &data.loops.program] {
            self.printable(program, Real::F64)?;
        }
        let mut errors = self.source.errors();
        for dense in &self.states {
            let numbers =
                |program| run(program, |input| Approximate::exact(dense.state.get(input)));
            let robot = data::robot(data, &numbers(&data.program));
            let robot = data::mechanism(robot, &data.loops, &numbers(&data.loops.program));
            let same = Dense::of(robot, dense.state.clone());
            let frames =
                list::ids(data.frames.len()).map(|frame| (Function::ForwardKinematics, frame));
            let others = [
                Function::InverseDynamics,
                Function::Constraint,
                Function::ConstraintJacobian,
            ];
            for (function, frame) in frames.chain(others.map(|function| (function, FrameId::FIRST)))
            {
                let Truth::Value(value) = function.truth() else {
                    continue;
                };
                let found = value(&same, frame);
                if let Some(wrong) = first_wrong(dense, function, (frame, Real::F64), &found) {
                    let message = format!("in the data, {}", self.words(function, &wrong));
                    errors.push_with_hint(self.place, message, FAULT);
                    return Err(errors);
                }
            }
        }
        Ok(())
    }

    fn printable(&self, program: &Program, scalar: Real) -> Result<(), Errors> {
        printable((&self.source, self.place), literals(program), scalar)
    }

    fn words(&self, function: Function, wrong: &Wrong) -> String {
        let Wrong {
            entry,
            found,
            expected,
        } = wrong;
        let name = function.name();
        let whose = match function.result() {
            Outcome::One(Quantity {
                over: &[space],
                entity: Entity::Number,
                ..
            }) => {
                let entry = &self.spaces.entries(space)[*entry];
                let what = match space {
                    Space::Coordinates | Space::Velocities => "joint",
                    Space::Parameters | Space::BaseParameters => "parameter",
                    Space::Constraints => "residual",
                    Space::Actions => "action",
                };
                format!(" ({what} {})", quoted(&entry.name))
            }
            _ => String::new(),
        };
        format!(
            "entry {entry}{whose} of {name} would be {found:e}, and is {expected:e} by the description"
        )
    }
}

/// Refuses the first number that is not one in the type that it is printed for.
fn printable(
    (source, place): (&Source, Place),
    numbers: impl Iterator<Item = f64>,
    scalar: Real,
) -> Result<(), Errors> {
    let mut errors = source.errors();
    for number in numbers {
        let (message, hint) = if !number.is_finite() {
            (
                "a number of the code would be too large for 64 bits, or the quotient of two \
                 that vanish"
                    .to_owned(),
                "give lengths in m, masses in kg and inertias in kg m²",
            )
        } else if scalar == Real::F32 && number.abs() > f64::from(f32::MAX) {
            (
                format!("a number of the code, {number:e}, is too large for f32"),
                "generate it for f64, or give lengths in m and masses in kg",
            )
        } else {
            continue;
        };
        errors.push_with_hint(place, message, hint);
        return Err(errors);
    }
    Ok(())
}

/// The numbers that stand in a program.
fn literals(program: &Program) -> impl Iterator<Item = f64> {
    program.operands().filter_map(|operand| match operand {
        Operand::Literal(number) => Some(number),
        _ => None,
    })
}

/// An entry that is not what it should be.
struct Wrong {
    entry: usize,
    found: f64,
    expected: f64,
}

/// How far off beside the largest entry a solution may be of which pivots are left out that roundings might
/// have made: no bound of it is finite.
const UNBOUNDED: f64 = 1e-6;

/// The first entry of a function that is not what the description says.
fn first_wrong(
    dense: &Dense,
    function: Function,
    (frame, scalar): (FrameId, Real),
    found: &[Approximate],
) -> Option<Wrong> {
    let expected = match function.truth() {
        Truth::Value(value) | Truth::OfMass(value) => value(dense, frame),
        Truth::Constrained(value) => value(dense, scalar.vanishing()),
        Truth::Solution(Given::Torques) => return solved::first_unsolved(dense, found),
        Truth::Solution(Given::MassMatrix) => return solved::first_not_inverse(dense, found),
        Truth::Solution(Given::TorqueDerivatives) => {
            return solved::first_wrong_derivative(dense, found);
        }
    };
    debug_assert_eq!(expected.len(), found.len());
    // Frames that are turned, and turned back, leave of a residue no more digits than 106 bits have
    // beside the whole.
    let sizes = expected.iter().map(|expected| expected.size());
    let largest = sizes.fold(0.0, f64::max);
    let whole = Approximate::literal(largest).noise();
    let mut pairs = found.iter().zip(&expected).enumerate();
    pairs.find_map(|(entry, (found, expected))| {
        let distance = (found.value - expected.value).to_f64().abs();
        let mut most = found.error + found.noise() + expected.noise() + whole;
        if function.is_constrained() {
            // What is solved for is as uncertain by what was written as by what is printed.
            most += expected.error;
            if !most.is_finite() {
                most = UNBOUNDED * largest;
            }
        }
        let (found, expected) = (found.to_f64(), expected.to_f64());
        wrong(entry, found, expected, distance <= most)
    })
}

fn wrong(entry: usize, found: f64, expected: f64, right: bool) -> Option<Wrong> {
    // What is not a number is not right.
    (!right).then_some(Wrong {
        entry,
        found,
        expected,
    })
}
