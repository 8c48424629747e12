//! Measured errors of programs that solve for accelerations.
//!
//! In: a chain, functions, and programs that compute them one after the other. Out: the expected error in a type of
//! numbers, in units of its roundoff. Each program is compared with a reference of a hundred bits, at states of the
//! robot's range and beyond its limits, and uphill from the worst of them. The result is no bound: in other states an
//! error may be larger.

mod rounded;
mod states;

use std::array::from_fn;

use super::program::expressions_by;
use super::solvable::field;
use crate::chain::Chain;
use crate::expression::{Double, Evaluation, Input};
use crate::formulation::Forward;
use crate::function::{Function, Given, Truth};
use crate::layout::Layout;
use crate::model::Algorithm;
use crate::random::Random;
use crate::real::Real;
use crate::schedule::{LANES, Lanes, Program, run};
use crate::space::{Arguments, FrameId};
use rounded::{Plain, Rounded, Single};
use states::{AngleRange, StateRanges};

/// The largest error allowed, relative to the largest result, in a thousand states \[u\].
pub(super) const LIMIT: f64 = 100.0;

/// The largest error that is accurate enough if it was estimated from a few states \[u\].
pub(super) const ENOUGH: f64 = 0.8 * LIMIT;

/// Number of states within the limits, of states at any angles, and of states of each step uphill.
const STATES: usize = 64;

/// Number of states after which a program with an error below [`NOTHING`] is done.
const FIRST: usize = 16;

/// A negligible error \[u\].
const NOTHING: f64 = 3.0;

/// Ratio of the worst of a thousand states to the mean of the worst eighth of [`STATES`]: four in the median of some
/// fifty robots, two to eight for most.
const TAIL: f64 = 4.0;

/// Number of states that each step uphill begins with, and the share of the worst in a step: one in eight.
const KEPT: usize = 8;

/// Number of steps uphill. One in sixteen of the states at the start is kept, one in eight of each step: the worst kept
/// state of the last step is one in a thousand.
const STEPS: usize = 2;

/// Number of operations beyond which a program does not go uphill, which would take seconds: the error at any angles is
/// estimated as it is within the limits, from [`FIRST`] states.
const LONG: usize = 20_000;

/// States of a chain, and the exact results of its functions there.
pub(super) struct Measure<'c> {
    chain: &'c Chain,
    scalar: Real,
    solved: Vec<Solved>,
    /// The mass matrix, if an inverse of it is among the results.
    mass: Option<Evaluation<Double>>,
    states: StateRanges<'c>,
    /// The states within the limits that have been needed.
    limited: Vec<ReferenceState>,
    /// The states at any angles that have been needed.
    any: Vec<ReferenceState>,
}

/// A function that solves an equation.
struct Solved {
    exactly: Evaluation<Double>,
    /// The place of its results among those of all functions.
    place: std::ops::Range<usize>,
    /// The place of an inverse of the mass matrix among the results of all functions.
    inverse: Option<std::ops::Range<usize>>,
    /// Factor of the error allowed.
    allowed: f64,
}

/// Factor of the error allowed for a function that solves an equation, compared to accelerations. Derivatives of
/// accelerations have rounded right sides and computed accelerations: the best form loses not much less than the
/// others.
pub(super) const fn allowed(function: Function) -> f64 {
    match function.truth() {
        Truth::Solution(
            Given::TorqueDerivatives
            | Given::Regressor
            | Given::Gradient
            | Given::Change
            | Given::Hessian,
        ) => 10.0,
        Truth::Value(_)
        | Truth::OfMass(_)
        | Truth::Directional(_)
        | Truth::Constrained(_)
        | Truth::Solution(_) => 1.0,
    }
}

/// Error of a program, relative to its largest result \[u\] and to the error allowed for the function.
#[derive(Clone, Copy, Debug)]
pub struct MeasuredError {
    /// In the worst of a thousand states, estimated from a few.
    pub worst: f64,
    /// Exceeded in at least an eighth of all states, to the same scale: a large value is a loss of the robot itself,
    /// not of a singular configuration that it passes through.
    pub eighth: f64,
    /// The largest error found, relative to the largest result of its function \[1\].
    pub found: f64,
    /// Number of random states; zero if nothing was measured.
    pub random: usize,
    /// Number of states uphill from the worst of them.
    pub uphill: usize,
}

impl MeasuredError {
    /// No error, or none measured.
    pub(super) const NONE: Self = Self {
        worst: 0.0,
        eighth: 0.0,
        found: 0.0,
        random: 0,
        uphill: 0,
    };

    /// No correct digit.
    pub(super) const INFINITE: Self = Self {
        worst: f64::INFINITY,
        eighth: f64::INFINITY,
        found: f64::INFINITY,
        random: 0,
        uphill: 0,
    };

    /// True if it was measured.
    #[must_use]
    pub const fn is_measured(&self) -> bool {
        self.random > 0
    }

    /// The better of two programs, in each respect.
    pub(super) const fn least(self, other: Self) -> Self {
        Self {
            worst: self.worst.min(other.worst),
            eighth: self.eighth.min(other.eighth),
            ..self
        }
    }
}

/// A program at a state.
#[derive(Clone)]
struct Tried {
    arguments: Arguments<f64>,
    /// The largest error, relative to the largest result and to the error allowed for the function \[u\].
    error: f64,
    /// The largest error, relative to the largest result \[1\].
    relative: f64,
}

impl Tried {
    fn worst_first(&self, other: &Self) -> std::cmp::Ordering {
        other.error.total_cmp(&self.error)
    }
}

/// A state, with the exact results of each function that solves an equation.
struct ReferenceState {
    arguments: Arguments<f64>,
    exact: Vec<Vec<Double>>,
    mass: Vec<Double>,
}

impl<'c> Measure<'c> {
    /// A measure of programs in a type of numbers. `loss` is the loss of the chain's mass matrix: the largest ratio
    /// of a diagonal entry to its pivot.
    pub(super) fn of(chain: &'c Chain, functions: &[Function], loss: f64, scalar: Real) -> Self {
        // Without refinement a hundred bits suffice up to this loss.
        const BORNE: f64 = 1e12;
        let refinements = usize::from(loss > BORNE);
        let forward = if chain.is_long() {
            Forward::Articulated
        } else {
            Forward::MassMatrix { refinements }
        };
        let algorithm = Algorithm {
            forward,
            ..Algorithm::PLAIN
        };
        let exactly = |function| {
            let (graph, results) = expressions_by(
                chain,
                &[function],
                FrameId::FIRST,
                Layout::DESCRIBED,
                algorithm,
            );
            Evaluation::of(&graph, &results)
        };
        let mut solved = Vec::new();
        let mut end = 0;
        for &function in functions {
            let start = end;
            end += function.result().size(chain.spaces());
            if function.solves() {
                let entries = Function::MassMatrix.result().size(chain.spaces());
                solved.push(Solved {
                    exactly: exactly(function),
                    place: start..end,
                    inverse: function.inverts().then(|| end - entries..end),
                    allowed: allowed(function),
                });
            }
        }
        let inverts = functions.iter().any(|function| function.inverts());
        Self {
            chain,
            scalar,
            solved,
            mass: inverts.then(|| exactly(Function::MassMatrix)),
            states: StateRanges::of(chain, scalar),
            limited: Vec::new(),
            any: Vec::new(),
        }
    }

    /// The error in the worst of a thousand states, estimated from a few, relative to the largest result, in units of
    /// the type's roundoff: within the limits and, if it is small there, at any angles. Infinite if a result is NaN.
    pub(super) fn error(&mut self, program: &Program) -> MeasuredError {
        let mut any = self.tried(program, AngleRange::Any, 0..FIRST);
        let is_negligible = any.iter().all(|tried| tried.error <= NOTHING);
        let (mut error, mut tried) = self.limited(program, is_negligible);
        if error.worst <= ENOUGH && tried.len() == STATES {
            if program.steps.len() > LONG {
                error.worst = error.worst.max(estimated(&mut any));
            } else {
                any.extend(self.tried(program, AngleRange::Any, FIRST..STATES));
            }
        }
        error.random = tried.len() + any.len();
        tried.append(&mut any);
        if error.random == 2 * STATES && error.worst <= ENOUGH && program.steps.len() <= LONG {
            error.uphill = self.go_uphill(program, &mut tried);
            error.worst = error.worst.max(ENOUGH / LIMIT * tried[KEPT - 1].error);
        }
        error.found = largest(tried.iter().map(|tried| tried.relative));
        error
    }

    /// The same within the limits alone.
    pub(super) fn error_within_limits(&mut self, program: &Program) -> MeasuredError {
        self.limited(program, true).0
    }

    /// The same, with the program at each state, worst first; at a few if its errors there are negligible, and it may
    /// stop at them.
    fn limited(&mut self, program: &Program, may_stop: bool) -> (MeasuredError, Vec<Tried>) {
        let mut tried = self.tried(program, AngleRange::Limited, 0..FIRST);
        if !(may_stop && tried.iter().all(|tried| tried.error <= NOTHING)) {
            tried.extend(self.tried(program, AngleRange::Limited, FIRST..STATES));
        }
        let error = MeasuredError {
            worst: estimated(&mut tried),
            eighth: TAIL * tried[tried.len() / KEPT - 1].error,
            ..MeasuredError::NONE
        };
        (error, tried)
    }

    /// Relative residual of M M⁻¹ − I at the worst of the states within the limits \[u\]. Near a singular configuration
    /// all forms lose the same digits of an inverse's largest entries, and yet one may invert and another not.
    pub(super) fn unsolved(&self, program: &Program) -> f64 {
        let inverts = self.mass.is_some();
        let states = self.limited.iter().filter(|_| inverts);
        let states: Vec<&ReferenceState> = states.collect();
        let found = self.found(program, &states);
        let unsolved = found
            .iter()
            .zip(states)
            .map(|(found, state)| self.residual(found, state));
        largest(unsolved) / self.scalar.roundoff()
    }

    /// Replaces states by the worst of them and states uphill: near them, with errors at least as large as theirs, and
    /// again from the worst of these. The worst are first. Returns the number of states that were tried.
    ///
    /// S.-K. Au, J. L. Beck, *Estimation of small failure probabilities in high dimensions by subset simulation*,
    /// Probabilistic Engineering Mechanics 16, 2001.
    fn go_uphill(&self, program: &Program, tried: &mut Vec<Tried>) -> usize {
        let mut random = Random(0);
        let mut count = 0;
        for _ in 0..STEPS {
            tried.sort_by(Tried::worst_first);
            tried.truncate(KEPT);
            let least = tried[KEPT - 1].error;
            if least > LIMIT {
                break;
            }
            for kept in 0..KEPT {
                let mut last = tried[kept].clone();
                for _ in 1..STATES / KEPT {
                    let near = self.exactly(self.states.near(&last.arguments, &mut random));
                    let found = self.found(program, &[&near]);
                    let near = self.judged(&near, &found[0]);
                    count += 1;
                    if near.error >= least {
                        last = near;
                    }
                    tried.push(last.clone());
                }
            }
        }
        tried.sort_by(Tried::worst_first);
        count
    }

    /// A program at states of some numbers, which are made when they are first needed.
    fn tried(
        &mut self,
        program: &Program,
        angles: AngleRange,
        numbers: std::ops::Range<usize>,
    ) -> Vec<Tried> {
        let of = |measure: &Self| match angles {
            AngleRange::Limited => measure.limited.len(),
            AngleRange::Any => measure.any.len(),
        };
        for number in of(self)..numbers.end {
            let state = self.exactly(self.states.numbered(number, angles));
            match angles {
                AngleRange::Limited => self.limited.push(state),
                AngleRange::Any => self.any.push(state),
            }
        }
        let states = match angles {
            AngleRange::Limited => &self.limited[numbers],
            AngleRange::Any => &self.any[numbers],
        };
        let states: Vec<&ReferenceState> = states.iter().collect();
        let found = self.found(program, &states);
        let tried = states.iter().zip(&found);
        tried
            .map(|(state, found)| self.judged(state, found))
            .collect()
    }

    /// A state with the exact results.
    fn exactly(&self, arguments: Arguments<f64>) -> ReferenceState {
        let input = |input| Double::from(at(&arguments, self.chain, input));
        let exact = self.solved.iter().map(|solved| solved.exactly.at(input));
        ReferenceState {
            exact: exact.collect(),
            mass: self.mass.iter().flat_map(|mass| mass.at(input)).collect(),
            arguments,
        }
    }

    /// The errors of the results of a program at a state.
    fn judged(&self, state: &ReferenceState, found: &[f64]) -> Tried {
        let (mut error, mut relative) = (0.0_f64, 0.0_f64);
        for (solved, exact) in self.solved.iter().zip(&state.exact) {
            let size = largest(exact.iter().map(|exact| exact.to_f64()));
            let errors = found[solved.place.clone()].iter().zip(exact);
            let errors = errors.map(|(&found, exact)| (Double::from(found) - *exact).to_f64());
            let off = match (size, largest(errors)) {
                // The exact result is infinite.
                (f64::INFINITY, _) => f64::INFINITY,
                // All exact results may be zero.
                (_, 0.0) => 0.0,
                (size, off) => off / size,
            };
            error = error.max(off / solved.allowed / self.scalar.roundoff());
            relative = relative.max(off);
        }
        Tried {
            arguments: state.arguments.clone(),
            error,
            relative,
        }
    }

    /// The results of a program in each of some states.
    fn found(&self, program: &Program, states: &[&ReferenceState]) -> Vec<Vec<f64>> {
        match self.scalar {
            Real::F32 => self.rounded::<Single>(program, states),
            Real::F64 | Real::Generic => self.rounded::<Plain>(program, states),
        }
    }

    fn rounded<T: Rounded>(&self, program: &Program, states: &[&ReferenceState]) -> Vec<Vec<f64>> {
        let entry =
            |state: &ReferenceState, input| T::literal(at(&state.arguments, self.chain, input));
        let together = states.chunks(LANES).flat_map(|states| {
            if let [state] = states {
                let found = run::<T>(program, |input| entry(state, input));
                return vec![found.iter().map(Rounded::to_f64).collect()];
            }
            let lane = |lane: usize| states.get(lane).unwrap_or(&states[0]);
            let lanes = |input| Lanes(from_fn(|of| entry(lane(of), input)));
            let found = run::<Lanes<T>>(program, lanes);
            let of = |lane: usize| found.iter().map(|lanes| lanes.0[lane].to_f64()).collect();
            (0..states.len()).map(of).collect()
        });
        together.collect()
    }

    /// The largest entry of M M⁻¹ − I, relative to the terms of its sum, in units that make all Mᵢᵢ = 1.
    fn residual(&self, found: &[f64], state: &ReferenceState) -> f64 {
        let count = self.chain.spaces().velocities.len();
        let units: Vec<f64> = (state.mass.iter().step_by(count + 1))
            .map(|entry| entry.to_f64().max(0.0).sqrt())
            .collect();
        let inverses = self
            .solved
            .iter()
            .filter_map(|solved| solved.inverse.clone());
        let mut worst: f64 = 0.0;
        for inverse in inverses.map(|place| &found[place]) {
            for j in 0..count {
                let column: Vec<f64> = inverse[j..].iter().step_by(count).copied().collect();
                let size: f64 = column
                    .iter()
                    .zip(&units)
                    .map(|(x, unit)| (x * unit).abs())
                    .sum();
                for (i, row) in state.mass.chunks(count).enumerate() {
                    let one = f64::from(u8::from(i == j));
                    let error = (row.iter().zip(&column))
                        .fold(Double::from(-one), |sum, (m, x)| {
                            sum + *m * Double::from(*x)
                        });
                    worst = largest([worst, error.to_f64() / (one + units[i] * size)].into_iter());
                }
            }
        }
        worst
    }
}

fn at(arguments: &Arguments<f64>, chain: &Chain, input: Input) -> f64 {
    match input {
        Input::Variable(variable, k) => arguments[variable][usize::from(k)],
        Input::Parameter(..) => Real::F32.rounded(field(chain, input)),
    }
}

/// The error in the worst of a thousand states, from a few, which it sorts worst first.
fn estimated(tried: &mut [Tried]) -> f64 {
    tried.sort_by(Tried::worst_first);
    let worst = tried[..tried.len() / KEPT].iter();
    let count: f64 = worst.clone().map(|_| 1.0).sum();
    TAIL * worst.map(|tried| tried.error).sum::<f64>() / count
}

/// The largest magnitude; infinite if one is NaN.
fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |most, number| {
        if number.is_nan() {
            f64::INFINITY
        } else {
            most.max(number.abs())
        }
    })
}
