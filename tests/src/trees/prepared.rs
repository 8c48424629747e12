//! A robot on both sides: what the generator understood of it, and the oracle's truth.
//!
//! In: a [`Robot`] and a [`Case`]. Out: what became of the program. Programs run in `f64`; states are
//! drawn joint by joint, so that a robot that has lost a joint is in the same state otherwise.

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

use crate::arguments::{Arguments, line};
use crate::oracle::frame_0;
use crate::programs::{program, program_as};
use crate::states::Random;

use super::cases::{Case, Choice};
use super::dense::{Dense, Entry};
use super::measure::Measure;
use super::regular::pivot;
use super::robot::{Asked, Field, NUMBERS, Robot};
use super::text;

/// What every function is right to, beside the sizes that [`measure`](super::measure) tells.
pub const TOLERANCE: f64 = 1e-10;

/// How far an entry of the mass matrix may sink by elimination before accelerations may be none.
const REGULAR: f64 = 1e-8;

/// The same for a function: derivatives solve with what their torques change by, which has been rounded, and with
/// accelerations that were found.
fn regular(function: Function) -> f64 {
    match function {
        Function::ForwardDynamicsDerivatives => 10.0 * REGULAR,
        _ => REGULAR,
    }
}

/// How much earlier a function may be refused by name: the engine does where four times the error that it measured,
/// which is of several roundings, leaves less than half of the digits.
const EARLIER: f64 = 10.0;

/// What became of a program.
pub enum Outcome {
    /// It was refused by name, and might be.
    Refused,
    /// It is right to so much.
    Within(f64),
    /// There is no such function of this robot.
    Nothing,
}

/// A robot on both sides, and states.
pub struct Prepared<'r> {
    robot: &'r Robot,
    chain: Chain,
    /// The engine's own judgement, which a user gets with every program.
    check: Check,
    dense: Dense,
    states: Vec<Arguments>,
    /// What is left of the mass matrix in each of them.
    pivots: OnceCell<Vec<f64>>,
}

impl<'r> Prepared<'r> {
    /// Reads a robot, and draws states for the joints that move.
    ///
    /// # Errors
    /// Where a reader or the engine refuses it, or other coordinates or velocities are listed than should be.
    pub fn of(robot: &'r Robot, seed: u64, states: usize) -> Result<Self, String> {
        let understood = guarded(|| {
            let (description, request) = text::read(robot)?;
            let chain = understand(&description, &request)?.identified();
            Check::of(&chain).map(|check| (chain, check))
        })?;
        let (chain, check) = understood.map_err(|errors| format!("refused: {errors}"))?;
        let mut dense = Dense::of(robot);
        dense.robot.identifies_drives = chain.identifies_drives;
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
            Arguments::of(|variable| match variable {
                Variable::Q => coordinates(&dense, seed, 4 * state),
                Variable::Qd => drawn(&dense.velocities, seed, 4 * state + 1),
                Variable::Qdd => drawn(&dense.velocities, seed, 4 * state + 2),
                Variable::Tau => drawn(&dense.velocities, seed, 4 * state + 3),
                Variable::Actions => pushes(robot, seed, state),
                other => unreachable!("no function has {other:?}"),
            })
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

    /// The truth about it.
    pub(super) const fn dense(&self) -> &Dense {
        &self.dense
    }

    /// What the generator made of it.
    #[must_use]
    pub const fn chain(&self) -> &Chain {
        &self.chain
    }

    /// Runs a program.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn check(&self, case: Case) -> Result<Outcome, String> {
        let frames = self.chain.frames.len();
        if case.function.of_a_frame() && frames == 0 {
            return Ok(Outcome::Nothing);
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
                // A robot may pass through a posture without accelerations, but must have others.
                let asked = case.choice != Choice::Default;
                let passes = asked || (0..self.states.len()).any(|state| !singular(state));
                if singular(state) && passes {
                    continue;
                }
                return Err(format!("{bad} of a finite state"));
            }
            let error = self.error(case, frame, &found, arguments);
            let allowed = self.allowed(case.function, state);
            // Not a number is no error within anything.
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

    /// The worst error of functions that are made as one.
    ///
    /// # Errors
    /// Where they are refused.
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

    /// The program of a case; none where it is refused by name, and may be.
    fn program(&self, case: Case, frame: FrameId) -> Result<Option<Program>, String> {
        let functions = [case.function];
        let singular = |state| self.is_singular(case.function, state);
        let refusable = regular(case.function) * EARLIER;
        let program = match case.choice {
            Choice::By(layout, way) => {
                // A form that nobody asked for may be one that this robot cannot bear.
                if (0..self.states.len()).any(singular) {
                    return Ok(None);
                }
                // Nor is there a centre of no mass.
                if case.function.is_of_mass() && self.is_weightless() {
                    return Ok(None);
                }
                return Ok(Some(program_by(
                    &self.chain,
                    &functions,
                    frame,
                    layout,
                    way,
                )));
            }
            Choice::Default => self.chosen(Formulation::default(), case.function, frame),
            Choice::Within(formulation) => self.chosen(formulation, case.function, frame),
        };
        program.map(Some).or_else(|errors| {
            let refusal = format!("refused: {errors}");
            // What the engine says of itself is no refusal.
            let own = refusal.contains("fault of homogen");
            // Of a small arm far from the base, frame 0 may keep too few digits.
            let far = case.in_frame_0() && refusal.contains("leave frame_0 out");
            let solves = case.function.solves();
            let weightless = case.function.is_of_mass() && refusal.contains("has mass");
            let states = || (0..self.states.len()).any(|state| self.sinks(state) < refusable);
            let described = || self.sinks_as_described() < refusable;
            let excused = || solves && (states() || described() || self.cancels());
            if far || weightless && self.is_weightless() || !own && excused() {
                Ok(None)
            } else {
                Err(refusal)
            }
        })
    }

    /// What a user gets: the program that the engine chooses, which has passed its own check.
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

    /// Whether nothing that moves is described with a mass.
    fn is_weightless(&self) -> bool {
        let described = Robot {
            asked: Asked {
                fields: Vec::new(),
                ..self.robot.asked.clone()
            },
            ..self.robot.clone()
        };
        frame_0::mass(&Dense::of(&described).robot) == 0.0
    }

    /// Whether a function of accelerations may be none: where the mass matrix is singular or nearly.
    fn is_singular(&self, function: Function, state: usize) -> bool {
        function.solves() && self.sinks(state) < regular(function)
    }

    /// What a function may be off by: more than usual where what is in a field leaves little of the mass matrix, since
    /// nobody knew it who could have chosen another form, or refused.
    fn allowed(&self, function: Function, state: usize) -> f64 {
        const ROUNDINGS: f64 = 32.0 * f64::EPSILON;
        if self.robot.asked.fields.is_empty() || !function.solves() {
            return TOLERANCE;
        }
        TOLERANCE.max(ROUNDINGS / pivot(&self.dense, &self.states[state]))
    }

    /// How far an entry of the mass matrix sinks by elimination in a state, with what is in the fields, with what is
    /// described in their place, or with what the engine takes for a field in whose place nothing but
    /// zeros are described: the end of its range.
    fn sinks(&self, state: usize) -> f64 {
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
                let asked = Asked {
                    fields,
                    ..self.robot.asked.clone()
                };
                Dense::of(&Robot {
                    asked,
                    ..self.robot.clone()
                })
            };
            let fields = self.robot.asked.fields.iter().zip(&self.chain.nominal);
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

    /// The same in the posture of the description, near which the engine looks at every eighth state.
    fn sinks_as_described(&self) -> f64 {
        let mut described = self.states[0].clone();
        let q = &mut described[Variable::Q];
        q.fill(0.0);
        for start in self.dense.robot.quaternions() {
            q[start + 3] = 1.0;
        }
        pivot(&self.dense, &described)
    }

    /// Whether a joint does what its follower takes back, so that rounding leaves half of the digits of
    /// accelerations at most.
    fn cancels(&self) -> bool {
        let measure = Measure::of(&self.dense, None, false);
        let drowned = |at: &Arguments| measure.drowned(at) > f64::EPSILON.sqrt();
        !self.chain.all_lead() && self.states.iter().any(drowned)
    }

    pub(super) fn input(&self, input: Input, arguments: &Arguments) -> f64 {
        match input {
            Input::Variable(Variable::Actions, k) => arguments[Variable::Actions][usize::from(k)],
            Input::Variable(variable, k) => {
                let place = self.place(variable.space(), usize::from(k));
                arguments[variable][place]
            }
            Input::Parameter(field, entry) => {
                self.robot.asked.fields[usize::from(field)].1[usize::from(entry)]
            }
        }
    }

    /// The place among the dense robot's of a coordinate or a velocity of the chain.
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

    /// The largest error of a result, in units of what it is made of.
    fn error(&self, case: Case, frame: FrameId, found: &[f64], arguments: &Arguments) -> f64 {
        let link = self.chain.frames.get(frame).map(|frame| id(&frame.name));
        let measure = Measure::of(&self.dense, link, case.in_frame_0());
        let found = self.in_order(case.function, found);
        measure.error(case.function, &found, arguments)
    }

    /// A result by the velocities of the dense robot instead of the chain's.
    pub(super) fn in_order(&self, function: Function, found: &[f64]) -> Vec<f64> {
        let mut order = vec![0; self.dense.velocities.len()];
        for velocity in 0..order.len() {
            order[self.place(Space::Velocities, velocity)] = velocity;
        }
        let parameters = self.parameters();
        let result = function.result();
        let parts = result.parts().zip(result.split(self.chain.spaces(), found));
        let parts = parts.map(|((_, part), found)| {
            let orders = part.over.iter().map(|space| match space {
                Space::Parameters => &*parameters,
                _ => &*order,
            });
            permuted(found, &orders.collect::<Vec<_>>())
        });
        parts.flatten().collect()
    }

    /// For each inertial parameter of the dense robot its place among the chain's: of each link that moves against the one
    /// it hangs on, ten; of what drives joints, three for each velocity.
    pub(super) fn parameters(&self) -> Vec<usize> {
        let places = self.links().into_iter();
        let parameters = places.flat_map(|place| (0..10).map(move |k| 10 * place + k));
        parameters.chain(self.drives()).collect()
    }

    /// For each link of the dense robot that moves against the one it hangs on, its place among the chain's.
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

    /// For each number of each drive of the dense robot its place among the chain's parameters; none where the chain
    /// identifies no drives.
    fn drives(&self) -> Vec<usize> {
        if !self.chain.identifies_drives {
            return Vec::new();
        }
        // A joint ends with the body that is its link.
        let mut link = None;
        let backwards = self.chain.joints.iter().rev().map(|joint| {
            link = joint.link.as_ref().map(|(name, _)| id(name)).or(link);
            link
        });
        let mut known: Vec<Option<usize>> = backwards.collect();
        known.reverse();
        let before = self.chain.spaces().parameters.len() - 3 * known.len();
        let places = self.dense.driven().into_iter().map(|link| {
            let place = known.iter().position(|other| *other == Some(link));
            let place = place.expect("the same joints");
            // The next of the same joint stands behind it.
            known[place] = None;
            before + 3 * place
        });
        places.flat_map(|first| first..first + 3).collect()
    }
}

/// The parts of nested arrays in other orders, the outermost first.
fn permuted(found: &[f64], orders: &[&[usize]]) -> Vec<f64> {
    let Some((order, inner)) = orders.split_first() else {
        return found.to_vec();
    };
    let each = found.len() / order.len();
    let parts = order.iter().map(|&k| &found[k * each..][..each]);
    parts.flat_map(|part| permuted(part, inner)).collect()
}

/// One number in [−4, 4) for each entry, which depends on nothing but the number of its joint and its part.
fn drawn(entries: &[Entry], seed: u64, of: u64) -> Vec<f64> {
    let number = |entry: &Entry| {
        let place = ((entry.joint as u64) << 48) ^ ((entry.part as u64) << 40);
        let mut random = Random::new(seed ^ (of << 32) ^ place);
        4.0 * random.unit()
    };
    entries.iter().map(number).collect()
}

/// c and f of each action from outside, which depend on nothing but the link.
fn pushes(robot: &Robot, seed: u64, state: u64) -> Vec<f64> {
    let actions = robot.acted_on().flat_map(|link| {
        let mut random = Random::new(seed ^ (state << 32) ^ ((link as u64) << 48) ^ 1);
        [(); 6].map(|()| 4.0 * random.unit())
    });
    actions.collect()
}

/// The same for coordinates, with quaternions of length 1 to rounding.
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

/// A panic as a message.
pub(super) fn guarded<X>(work: impl FnOnce() -> X) -> Result<X, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        let text = text.or_else(|| panic.downcast_ref::<&str>().map(|&text| text.to_owned()));
        format!("a panic: {}", text.unwrap_or_default())
    })
}
