//! A random robot in the generator and in the oracle.
//!
//! In: a [`Robot`] and a [`Case`]. Out: the outcome of the program, run in `f64`. States are drawn joint by joint, so
//! that a robot from which a joint was removed is otherwise at the same state.

use std::cell::OnceCell;
use std::panic::{AssertUnwindSafe, catch_unwind};

use homogen_codegen::chain::Chain;
use homogen_codegen::check::Check;
use homogen_codegen::error::Errors;
use homogen_codegen::expand::understand;
use homogen_codegen::expression::Input;
use homogen_codegen::formulation::Formulation;
use homogen_codegen::list::Id;
use homogen_codegen::plan::program_by;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::{FrameId, Space, Variable};
use homogen_codegen::{Function, Real};

use crate::arguments::{Arguments, fill_changes, line};
use crate::oracle::frame_0;
use crate::programs::{program, program_as};
use crate::states::Random;

use super::cases::{Case, Choice};
use super::dense::{Dense, Entry};
use super::measure::Measure;
use super::regular::pivot;
use super::robot::{Field, NUMBERS, Options, Robot};
use super::text;

/// The limit of the errors of [`measure`](super::measure).
pub const TOLERANCE: f64 = 1e-10;

/// Relative pivot of the mass matrix below which a state counts as singular.
const REGULAR: f64 = 1e-8;

/// The same for a function. Derivatives are solutions with right-hand sides that are rounded, and at accelerations that
/// are solutions themselves.
fn regular(function: Function) -> f64 {
    match function {
        Function::ForwardDynamicsDerivatives
        | Function::ForwardDynamicsVjp
        | Function::ForwardDynamicsJvp
        | Function::ForwardDynamicsHessian => 10.0 * REGULAR,
        _ => REGULAR,
    }
}

/// Factor of the pivot up to which a function may be refused by name. The engine refuses if four times its measured
/// error, of several roundings, leaves less than half of the digits.
const EARLIER: f64 = 10.0;

/// The outcome of a program without a failure.
pub enum Outcome {
    /// Refused by name, as it may be.
    Refused,
    /// Right, with this error.
    Within(f64),
    /// The robot has no such function.
    NotApplicable,
}

/// A robot in the generator and in the oracle, with states.
pub struct Prepared<'r> {
    robot: &'r Robot,
    chain: Chain,
    /// The engine's own check of every program.
    check: Check,
    dense: Dense,
    states: Vec<Arguments>,
    /// The smallest relative pivot of the mass matrix at each state.
    pivots: OnceCell<Vec<f64>>,
}

impl<'r> Prepared<'r> {
    /// Reads a robot, and draws states.
    ///
    /// # Errors
    /// If a reader or the engine rejects it, or the names of coordinates or velocities differ from the expected ones.
    pub fn of(robot: &'r Robot, seed: u64, states: usize) -> Result<Self, String> {
        let understood = guarded(|| {
            let (description, request) = text::read(robot)?;
            let chain = understand(&description, &request)?.identified();
            Check::of(&chain).map(|check| (chain, check))
        })?;
        let (chain, check) = understood.map_err(|errors| format!("refused: {errors}"))?;
        let mut dense = Dense::of(robot);
        dense.robot.identifies_actuators = chain.identifies_actuators;
        let spaces = chain.spaces();
        for (space, entries) in [
            (Space::Coordinates, &dense.coordinates),
            (Space::Velocities, &dense.velocities),
        ] {
            let mut found: Vec<&str> = spaces.names(space).collect();
            let mut expected: Vec<&str> = entries.iter().map(|entry| &*entry.name).collect();
            found.sort_unstable();
            expected.sort_unstable();
            if found != expected {
                return Err(format!("{space:?} are {found:?} instead of {expected:?}"));
            }
        }
        let of_state = |state| {
            let mut arguments = Arguments::of(|variable| match variable {
                Variable::Q => coordinates(&dense, seed, 4 * state),
                Variable::Qd => drawn(&dense.velocities, seed, 4 * state + 1),
                Variable::Qdd => drawn(&dense.velocities, seed, 4 * state + 2),
                Variable::Tau => drawn(&dense.velocities, seed, 4 * state + 3),
                Variable::Weights => drawn(&dense.velocities, !seed, 4 * state),
                Variable::Wrench => wrench(&mut Random::new(seed ^ (state << 32) ^ 2_u64)).into(),
                Variable::Actions => wrenches(robot, seed, state),
                change if change.is_change() => Vec::new(),
                other => unreachable!("no function has {other:?}"),
            });
            fill_changes(&mut arguments);
            arguments
        };
        let states = (0..states as u64).map(of_state).collect();
        Ok(Self {
            robot,
            chain,
            check,
            dense,
            states,
            pivots: OnceCell::new(),
        })
    }

    /// The robot in dense matrices.
    pub(super) const fn dense(&self) -> &Dense {
        &self.dense
    }

    /// The chain that the generator builds.
    #[must_use]
    pub const fn chain(&self) -> &Chain {
        &self.chain
    }

    /// Runs a program.
    ///
    /// # Errors
    /// A description of the failure.
    pub fn check(&self, case: Case) -> Result<Outcome, String> {
        let frames = self.chain.frames.len();
        if case.function.needs_a_frame() && frames == 0 {
            return Ok(Outcome::NotApplicable);
        }
        let frame = FrameId::new(case.frame % frames.max(1));
        let Some(program) = guarded(|| self.program(case, frame))?? else {
            return Ok(Outcome::Refused);
        };
        let singular = |state| self.is_singular(case.function, state);
        let mut worst: f64 = 0.0;
        for (state, arguments) in self.states.iter().enumerate() {
            let found = run::<f64>(&program, |input| self.input(input, arguments));
            if let Some(bad) = found.iter().find(|entry| !entry.is_finite()) {
                // A robot may pass through a singular configuration, but not all of its states may be singular.
                let options = case.choice != Choice::Default;
                let passes = options || (0..self.states.len()).any(|state| !singular(state));
                if singular(state) && passes {
                    continue;
                }
                return Err(format!("{bad} of a finite state"));
            }
            let error = self.error(case, frame, &found, arguments);
            let allowed = self.allowed(case.function, state);
            // False for NaN.
            if error.partial_cmp(&allowed) != Some(std::cmp::Ordering::Less) {
                return Err(format!(
                    "an error of {error:.1e}\n{} found {found:?}",
                    line(arguments)
                ));
            }
            worst = worst.max(error);
        }
        Ok(Outcome::Within(worst))
    }

    /// The worst error of functions that are generated together.
    ///
    /// # Errors
    /// If they are refused.
    pub fn together(&self, functions: &[Function]) -> Result<f64, String> {
        let program = guarded(|| program(&self.chain, functions, FrameId::FIRST, Real::F64))?;
        let program = program.map_err(|errors| format!("refused: {errors}"))?;
        let judged = self
            .check
            .judge_program(functions, FrameId::FIRST, &program, Real::F64);
        judged.map_err(|errors| format!("refused: {errors}"))?;
        let mut worst: f64 = 0.0;
        for arguments in &self.states {
            let found = run::<f64>(&program, |input| self.input(input, arguments));
            let mut found = found.as_slice();
            for &function in functions {
                let (these, rest) = found.split_at(function.result().size(self.chain.spaces()));
                found = rest;
                let case = Case {
                    function,
                    frame: 0,
                    choice: Choice::Default,
                };
                worst = worst.max(self.error(case, FrameId::FIRST, these, arguments));
            }
        }
        Ok(worst)
    }

    /// The program of a case; `None` if it is refused by name, and may be.
    fn program(&self, case: Case, frame: FrameId) -> Result<Option<Program>, String> {
        let functions = [case.function];
        let singular = |state| self.is_singular(case.function, state);
        let refusable = regular(case.function) * EARLIER;
        let program = match case.choice {
            Choice::By(layout, algorithm) => {
                // A layout or algorithm chosen at random may be unsuitable for this robot.
                if (0..self.states.len()).any(singular) {
                    return Ok(None);
                }
                // A robot without mass has no centre of mass.
                if case.function.is_of_mass() && self.is_weightless() {
                    return Ok(None);
                }
                return Ok(Some(program_by(
                    &self.chain,
                    &functions,
                    frame,
                    layout,
                    algorithm,
                )));
            }
            Choice::Default => self.chosen(Formulation::default(), case.function, frame),
            Choice::Within(formulation) => self.chosen(formulation, case.function, frame),
        };
        program.map(Some).or_else(|errors| {
            let refusal = format!("refused: {errors}");
            // A failure of the engine's own check is no refusal.
            let own = refusal.contains("fault of homogen");
            // For a small arm far from the base, frame 0 may lose too many digits.
            let far = case.in_frame_0() && refusal.contains("leave frame_0 out");
            let solves = case.function.solves();
            let weightless =
                case.function.is_of_mass() && refusal.contains("no joint moves a mass");
            let states = || (0..self.states.len()).any(|state| self.least_pivot(state) < refusable);
            let described = || self.pivot_as_described() < refusable;
            let excused = || solves && (states() || described() || self.cancels());
            if far || weightless && self.is_weightless() || !own && excused() {
                Ok(None)
            } else {
                Err(refusal)
            }
        })
    }

    /// The program of a user: that of the engine's choice, which has passed the engine's check.
    fn chosen(
        &self,
        formulation: Formulation,
        function: Function,
        frame: FrameId,
    ) -> Result<Program, Errors> {
        let functions = [function];
        let program = program_as(formulation, &self.chain, &functions, frame, Real::F64)?;
        self.check
            .judge_program(&functions, frame, &program, Real::F64)?;
        Ok(program)
    }

    /// True if no body that moves is described with a mass.
    fn is_weightless(&self) -> bool {
        let described = Robot {
            options: Options {
                fields: Vec::new(),
                ..self.robot.options.clone()
            },
            ..self.robot.clone()
        };
        frame_0::mass(&Dense::of(&described).robot) == 0.0
    }

    /// True if a function may have no result at a state, since the mass matrix is nearly singular.
    fn is_singular(&self, function: Function, state: usize) -> bool {
        function.solves() && self.least_pivot(state) < regular(function)
    }

    /// The limit of an error: larger where values of fields make the mass matrix nearly singular, since they were
    /// unknown when the algorithm was chosen.
    fn allowed(&self, function: Function, state: usize) -> f64 {
        const ROUNDINGS: f64 = 32.0 * f64::EPSILON;
        if self.robot.options.fields.is_empty() || !function.solves() {
            return TOLERANCE;
        }
        TOLERANCE.max(ROUNDINGS / pivot(&self.dense, &self.states[state]))
    }

    /// The smallest relative pivot of the mass matrix at a state: with the values of the fields, with the described
    /// values in their place, or with the end of the engine's range for a field whose described values are zero.
    fn least_pivot(&self, state: usize) -> f64 {
        const END: f64 = 1.0; // 1 kg, 1 m, 1 kg m² or 1 m/s²
        let end = |field: Field| -> [f64; NUMBERS] {
            let (far, wide) = (0.25, 0.0625);
            match field {
                Field::Payload(_) => [END, far, far, far, wide, 0.0, 0.0, wide, 0.0, wide],
                Field::Inertia(_) => [END, 0.0, 0.0, END, 0.0, END, 0.0, 0.0, 0.0, 0.0],
                Field::Placement(_) => [0.0; NUMBERS],
                _ => [END; NUMBERS],
            }
        };
        let pivots = self.pivots.get_or_init(|| {
            let with = |fields: Vec<(Field, [f64; NUMBERS])>| {
                let options = Options {
                    fields,
                    ..self.robot.options.clone()
                };
                Dense::of(&Robot {
                    options,
                    ..self.robot.clone()
                })
            };
            let fields = self.robot.options.fields.iter().zip(&self.chain.nominal);
            let undescribed =
                fields.filter(|(_, nominal)| nominal.iter().all(|&entry| entry == 0.0));
            let at_the_end = undescribed.map(|((field, _), _)| (*field, end(*field)));
            let others = [with(Vec::new()), with(at_the_end.collect())];
            let least = |state| {
                let others = others.iter().map(|other| pivot(other, state));
                others.fold(pivot(&self.dense, state), f64::min)
            };
            self.states.iter().map(least).collect()
        });
        pivots[state]
    }

    /// The relative pivot in the configuration of the description, near which the engine measures at every eighth
    /// state.
    fn pivot_as_described(&self) -> f64 {
        let mut described = self.states[0].clone();
        let q = &mut described[Variable::Q];
        q.fill(0.0);
        for start in self.dense.robot.quaternions() {
            q[start + 3] = 1.0;
        }
        pivot(&self.dense, &described)
    }

    /// True if a mimic joint cancels the motion of its mimicked joint so nearly that rounding leaves at most half of
    /// the digits of accelerations.
    fn cancels(&self) -> bool {
        let measure = Measure::of(&self.dense, &[], false);
        let is_lost = |at: &Arguments| measure.rounding_of_accelerations(at) > f64::EPSILON.sqrt();
        !self.chain.all_lead() && self.states.iter().any(is_lost)
    }

    pub(super) fn input(&self, input: Input, arguments: &Arguments) -> f64 {
        match input {
            Input::Variable(variable @ (Variable::Wrench | Variable::Actions), k) => {
                arguments[variable][usize::from(k)]
            }
            Input::Variable(variable, k) => {
                let place = self.place(variable.space(), usize::from(k));
                arguments[variable][place]
            }
            Input::Parameter(field, entry) => {
                self.robot.options.fields[usize::from(field)].1[usize::from(entry)]
            }
        }
    }

    /// The index, in the dense robot, of a coordinate or velocity of the chain.
    pub(super) fn place(&self, space: Space, index: usize) -> usize {
        let name = &self.chain.spaces().entries(space)[index].name;
        let entries = match space {
            Space::Coordinates => &self.dense.coordinates,
            _ => &self.dense.velocities,
        };
        let mut entries = entries.iter();
        entries
            .position(|entry| entry.name == *name)
            .expect("the same entries")
    }

    /// The largest relative error of a result.
    fn error(&self, case: Case, frame: FrameId, found: &[f64], arguments: &Arguments) -> f64 {
        let links = self.links_of(case.function, frame);
        let measure = Measure::of(&self.dense, &links, case.in_frame_0());
        let found = self.in_order(case.function, found);
        measure.error(case.function, &found, arguments)
    }

    /// The link of the frame of a function, or those of all frames.
    pub(super) fn links_of(&self, function: Function, frame: FrameId) -> Vec<usize> {
        let frames = &self.chain.frames;
        let is_of = |k: FrameId| k == frame || !function.of_a_frame();
        let frames = frames.numbered().filter(|(k, _)| is_of(*k));
        frames.map(|(_, frame)| id(&frame.name)).collect()
    }

    /// A result in the order of the dense robot's velocities.
    pub(super) fn in_order(&self, function: Function, found: &[f64]) -> Vec<f64> {
        let mut order = vec![0; self.dense.velocities.len()];
        for velocity in 0..order.len() {
            order[self.place(Space::Velocities, velocity)] = velocity;
        }
        let parameters = self.parameters();
        let frames: Vec<usize> = (0..self.chain.frames.len()).collect();
        let result = function.result();
        let parts = result.parts().zip(result.split(self.chain.spaces(), found));
        let parts = parts.map(|((_, part), found)| {
            let orders = part.over.iter().map(|space| match space {
                Space::Parameters => &*parameters,
                Space::Frames => &*frames,
                _ => &*order,
            });
            permuted(found, &orders.collect::<Vec<_>>())
        });
        parts.flatten().collect()
    }

    /// For each inertial parameter of the dense robot, its index among those of the chain: ten for each link that a
    /// joint moves, three for each velocity with actuator parameters.
    pub(super) fn parameters(&self) -> Vec<usize> {
        let places = self.links().into_iter();
        let parameters = places.flat_map(|place| (0..10).map(move |k| 10 * place + k));
        parameters.chain(self.actuator_parameters()).collect()
    }

    /// For each link of the dense robot that a joint moves, its index among those of the chain.
    fn links(&self) -> Vec<usize> {
        let parameters = &self.chain.spaces().parameters;
        let names = parameters
            .iter()
            .filter_map(|entry| entry.name.strip_suffix(".m"));
        let known: Vec<usize> = names.map(id).collect();
        let bodies = self.dense.robot.bodies.iter().zip(&self.dense.links);
        let links = bodies.filter(|(body, _)| body.link);
        let links = links.filter_map(|(_, link)| *link);
        let place = |link| known.iter().position(|&other| other == link);
        links
            .map(|link| place(link).expect("the same links"))
            .collect()
    }

    /// For each actuator parameter of the dense robot, its index among those of the chain; none if the chain does not
    /// identify them.
    fn actuator_parameters(&self) -> Vec<usize> {
        if !self.chain.identifies_actuators {
            return Vec::new();
        }
        // The last body of a joint has its link.
        let mut link = None;
        let backwards = self.chain.joints.iter().rev().map(|joint| {
            link = joint.link.as_ref().map(|(name, _)| id(name)).or(link);
            link
        });
        let mut known: Vec<Option<usize>> = backwards.collect();
        known.reverse();
        let before = self.chain.spaces().parameters.len() - 3 * known.len();
        let places = self.dense.actuated_links().into_iter().map(|link| {
            let place = known.iter().position(|other| *other == Some(link));
            let place = place.expect("the same joints");
            // The next velocity of the same joint is behind it.
            known[place] = None;
            before + 3 * place
        });
        places.flat_map(|first| first..first + 3).collect()
    }
}

/// Parts of nested arrays in another order, the outermost first.
fn permuted(found: &[f64], orders: &[&[usize]]) -> Vec<f64> {
    let Some((order, inner)) = orders.split_first() else {
        return found.to_vec();
    };
    let each = found.len() / order.len();
    let parts = order.iter().map(|&k| &found[k * each..][..each]);
    parts.flat_map(|part| permuted(part, inner)).collect()
}

/// A number in [−4, 4) for each entry, determined by the seed, the number of its joint and its part.
fn drawn(entries: &[Entry], seed: u64, of: u64) -> Vec<f64> {
    let number = |entry: &Entry| {
        let place = ((entry.joint as u64) << 48) ^ ((entry.part as u64) << 40);
        let mut random = Random::new(seed ^ (of << 32) ^ place);
        4.0 * random.unit()
    };
    entries.iter().map(number).collect()
}

/// c and f of each external wrench, determined by the seed, the state and the link.
fn wrenches(robot: &Robot, seed: u64, state: u64) -> Vec<f64> {
    let actions = robot.acted_on().flat_map(|link| {
        let seed = seed ^ (state << 32) ^ ((link as u64) << 48) ^ 1;
        wrench(&mut Random::new(seed))
    });
    actions.collect()
}

fn wrench(random: &mut Random) -> [f64; 6] {
    [(); 6].map(|()| 4.0 * random.unit())
}

/// The same for coordinates, with normalised quaternions.
fn coordinates(dense: &Dense, seed: u64, of: u64) -> Vec<f64> {
    let mut q = drawn(&dense.coordinates, seed, of);
    for start in dense.robot.quaternions() {
        let quaternion = &mut q[start..start + 4];
        let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
        for entry in quaternion {
            *entry /= length;
        }
    }
    q
}

/// The number at the end of `joint3` or `link3`.
pub(super) fn id(name: &str) -> usize {
    let digits = name.trim_start_matches(char::is_alphabetic);
    digits.parse().expect("names end in their number")
}

/// The result of a function; a panic is an error with its message.
pub(super) fn guarded<X>(work: impl FnOnce() -> X) -> Result<X, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|&text| text.to_owned()));
        format!("a panic: {}", text.unwrap_or_default())
    })
}
