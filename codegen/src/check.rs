//! The check of every expansion, before it is printed.
//!
//! In: a description, the request, and the programs to be printed. Out: an error with function, entry and both
//! numbers if a program is wrong. The programs are run at a few states in 106 bits and compared with products of 4×4
//! matrices of the description as written: without merging, layout, regrouping, rules or schedule. The rounding of
//! their literals to `f64` bounds the difference that is allowed.

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
use crate::dense::{Approximate, Dense, State, row_times};
use crate::description::Source;
use crate::error::{Errors, Place};
use crate::expression::{Arithmetic, Input};
use crate::function::{Function, Given, Truth};
use crate::list::{self, List, Square};
use crate::module::{ChainData, Module};
use crate::plan::Planned;
use crate::real::Real;
use crate::schedule::{Operand, Program, run};
use crate::space::{Entity, FrameId, Outcome, Quantity, Space, Spaces, Variable, VelocityId};
use crate::wording::quoted;
pub use base_parameters::judge_base_parameters;
pub use redundancy::{Redundancy, redundancy};
use robot::Contradiction;
#[cfg(feature = "files")]
pub use vectors::vectors;

/// A robot at a few states, with which programs are compared.
pub struct Check {
    source: Source,
    place: Place,
    spaces: Spaces,
    states: Vec<Dense>,
    /// The error of its base parameters, if there is one.
    base_parameters: Result<(), Errors>,
}

/// Largest number of joints checked at several states; longer robots are checked at one, which takes as long.
const SEVERAL: usize = 20;

/// The hint of errors that are faults of the engine.
const FAULT: &str =
    "this is a fault of homogen and not of the description: please report it, with the description";

/// True if an error is a fault of the engine, and not of the description or the request.
#[must_use]
pub fn is_fault(refusal: &Errors) -> bool {
    let mut hints = refusal
        .diagnostics()
        .iter()
        .map(|diagnostic| diagnostic.hint.as_deref());
    hints.any(|hint| hint == Some(FAULT))
}

/// An error that is a fault of the engine, for tests of its handling.
#[cfg(test)]
pub(crate) fn fault(message: &str) -> Errors {
    let mut errors = Errors::new();
    errors.push_with_hint(Place::Unknown, message, FAULT);
    errors
}

impl Check {
    /// Computes the robot of a chain's description.
    ///
    /// # Errors
    /// If description and chain disagree on which joints move, or on the meaning of a number.
    pub fn of(chain: &Chain) -> Result<Self, Errors> {
        let place = chain.description.name.place;
        let count = if chain.joints.len() > SEVERAL { 1 } else { 2 };
        let at = |state: &State| {
            let robot = robot::robot(chain, &state.fields)?;
            Ok(Dense::of(robot, state.clone()))
        };
        let states = || {
            let mut states = states::states(chain, count);
            // The equations of the loops hold in every state; dependent ones only in closed configurations.
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

    /// Compares a plan with the description; an error replaces a wrong plan.
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

    /// Compares the other parts of a module with the description: the robot as data, and the prepared part.
    ///
    /// # Errors
    /// If one of them is wrong.
    pub fn judge_module(&self, module: &Module) -> Result<(), Errors> {
        let mut errors = Errors::new();
        for judged in [self.judge_data(&module.data), self.judge_prepared(module)] {
            if let Err(refusal) = judged {
                errors.append(refusal);
            }
        }
        errors.into_result(())
    }

    /// Compares a program that computes some functions one after the other, for a frame, with the description.
    ///
    /// # Errors
    /// If a result is wrong, or if a number of the program is not finite in the type that it is printed for.
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

    /// Compares prepared functions with the whole ones, bit for bit.
    ///
    /// # Errors
    /// If a result differs.
    fn judge_prepared(&self, module: &Module) -> Result<(), Errors> {
        let mut errors = self.source.errors();
        let Some(prepared) = &module.prepared else {
            return Ok(());
        };
        for dense in &self.states {
            let state = |input| dense.state.get(input).to_f64();
            let values = run(&prepared.once, state);
            let either = |input| match input {
                Input::Parameter(_, value) => values[usize::from(value)],
                Input::Variable(..) => state(input),
            };
            for (whole, left) in module.functions.iter().zip(&prepared.functions) {
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

    /// Compares the robot as data with the description: its frames, the torques of its motion, and the residuals of its
    /// loops with their derivatives.
    ///
    /// # Errors
    /// If one of them is wrong, or a number is not finite.
    pub(crate) fn judge_data(&self, data: &ChainData) -> Result<(), Errors> {
        for program in [&data.program, &data.loops.program] {
            self.printable(program, Real::F64)?;
        }
        let mut errors = self.source.errors();
        for dense in &self.states {
            let numbers =
                |program| run(program, |input| Approximate::exact(dense.state.get(input)));
            let robot = data::robot(data, &numbers(&data.program));
            let robot = data::closed_loops(robot, &data.loops, &numbers(&data.loops.program));
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
                    Space::Wrench | Space::Actions => "action",
                    Space::Frames => "frame",
                    Space::Spheres => "sphere",
                    Space::Pairs => "pair",
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

/// Rejects the first number that is not finite in the type that it is printed for.
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

/// The literals of a program.
fn literals(program: &Program) -> impl Iterator<Item = f64> {
    program.operands().filter_map(|operand| match operand {
        Operand::Literal(number) => Some(number),
        _ => None,
    })
}

/// A wrong entry.
struct Wrong {
    entry: usize,
    found: f64,
    expected: f64,
}

/// Relative error allowed for a result without a finite bound: of a division by a number that may be a rounding error.
const UNBOUNDED: f64 = 1e-6;

/// The first entry of a function that disagrees with the description.
fn first_wrong(
    dense: &Dense,
    function: Function,
    (frame, scalar): (FrameId, Real),
    found: &[Approximate],
) -> Option<Wrong> {
    let contracted;
    let (found, expected) = match function.truth() {
        Truth::Value(value) | Truth::OfMass(value) => (found, value(dense, frame)),
        Truth::Directional(value) => {
            let direction = direction(dense, function);
            contracted = sums_of_rows(found, &direction);
            (&*contracted, value(dense, &direction))
        }
        Truth::Constrained(value) => (found, value(dense, scalar.zero_pivot())),
        Truth::Solution(Given::Torques) => return solved::first_unsolved(dense, found),
        Truth::Solution(Given::MassMatrix) => return solved::first_not_inverse(dense, found),
        Truth::Solution(Given::TorqueDerivatives) => {
            return solved::first_wrong_derivative(dense, found);
        }
        Truth::Solution(Given::Regressor) => {
            return solved::first_unlike(&dense.accelerations_by_parameters()?, found);
        }
        Truth::Solution(Given::Gradient) => {
            return solved::first_unlike(&dense.with_accelerations()?.gradient(), found);
        }
        Truth::Solution(Given::Change) => {
            return solved::first_unlike(&dense.with_accelerations()?.change(), found);
        }
        Truth::Solution(Given::Hessian) => {
            let direction = direction(dense, function);
            let contracted = sums_of_rows(found, &direction);
            return solved::first_unlike(
                &dense.with_accelerations()?.hessian(&direction),
                &contracted,
            );
        }
    };
    assert_eq!(expected.len(), found.len());
    // Rotating a residue and back leaves it with as many digits as 106 bits have beside the whole vector.
    let sizes = expected.iter().map(|expected| expected.size());
    let largest = sizes.fold(0.0, f64::max);
    let whole = Approximate::literal(largest).noise();
    let mut pairs = found.iter().zip(&expected).enumerate();
    pairs.find_map(|(entry, (found, expected))| {
        let distance = (found.value - expected.value).to_f64().abs();
        let mut most = found.error + found.noise() + expected.noise() + whole;
        if function.is_constrained() {
            // A solution has the uncertainty of the described numbers and of the printed ones.
            most += expected.error;
        }
        if !most.is_finite() {
            most = UNBOUNDED * largest;
        }
        let (found, expected) = (found.to_f64(), expected.to_f64());
        wrong(entry, found, expected, distance <= most)
    })
}

/// A direction with random entries: that of τ and q̈ which is no argument of the function.
fn direction(dense: &Dense, function: Function) -> List<VelocityId, Approximate> {
    dense.state.of_velocities(match function.arguments() {
        arguments if arguments.contains(&Variable::Tau) => Variable::Qdd,
        _ => Variable::Tau,
    })
}

/// The sums of the rows of some square matrices, one after the other, times the entries of a direction.
fn sums_of_rows(
    matrices: &[Approximate],
    direction: &List<VelocityId, Approximate>,
) -> Vec<Approximate> {
    let size = direction.len();
    let matrices = matrices.chunks(size * size);
    let sums = matrices.flat_map(|matrix| row_times(direction, &Square::of_rows(matrix)));
    sums.collect()
}

fn wrong(entry: usize, found: f64, expected: f64, right: bool) -> Option<Wrong> {
    // NaN is wrong as well.
    (!right).then_some(Wrong {
        entry,
        found,
        expected,
    })
}
