//! Measured errors of programs that solve for accelerations.
//!
//! In: a chain, functions, and programs that compute them one after the other. Out: the expected error in a type of
//! numbers, in units of its roundoff. Each program is run at states of the robot's range and compared with a reference
//! of a hundred bits. The result is no bound: in other states an error may be larger.

use super::program::expressions_by;
use super::solvable::field;
use crate::chain::Chain;
use crate::expression::{Arithmetic, Double, Evaluation, Input};
use crate::formulation::Forward;
use crate::function::{Function, Given, Truth};
use crate::layout::Layout;
use crate::list::Id;
use crate::model::Algorithm;
use crate::quaternion::of_length_1;
use crate::range::Range;
use crate::real::Real;
use crate::schedule::{Program, run};
use crate::space::{Arguments, FrameId, Variable};

/// The largest error allowed, relative to the largest result, in a thousand states \[u\].
pub(super) const LIMIT: f64 = 100.0;

/// The largest error that is accurate enough if it was estimated from a few states \[u\].
pub(super) const ENOUGH: f64 = 0.8 * LIMIT;

/// Number of states.
const STATES: u32 = 64;

/// Number of states after which a program with an error below [`NOTHING`] is done.
const FIRST: u32 = 16;

/// A negligible error \[u\].
const NOTHING: f64 = 3.0;

/// Ratio of the worst of a thousand states to the mean of the worst eighth of [`STATES`]: four in the median of some
/// fifty robots, two to eight for most.
const TAIL: f64 = 4.0;

/// Share of the range for states near another state.
const NEAR: f64 = 1e-3;

/// Size of joint forces and torques \[N m or N\]: so small that most robots' accelerations come from the motion.
const TORQUE: f64 = 4.0;

/// States of a chain, and the exact results of its functions there.
pub(super) struct Measure<'c> {
    chain: &'c Chain,
    scalar: Real,
    range: Range,
    solved: Vec<Solved>,
    /// The mass matrix, if an inverse of it is among the results.
    mass: Option<Evaluation<Double>>,
    states: Vec<State>,
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
        Truth::Solution(Given::TorqueDerivatives) => 10.0,
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
    /// Relative residual of M M⁻¹ − I at the worst state. Near a singular configuration all forms lose the same
    /// digits of an inverse's largest entries, and yet one may invert and another not. Not measured if the results
    /// are accurate enough.
    pub unsolved: f64,
}

impl MeasuredError {
    /// No error, or none measured.
    pub(super) const NONE: Self = Self {
        worst: 0.0,
        eighth: 0.0,
        unsolved: 0.0,
    };

    /// No correct digit.
    pub(super) const INFINITE: Self = Self {
        worst: f64::INFINITY,
        eighth: f64::INFINITY,
        unsolved: f64::INFINITY,
    };

    /// The better of two programs.
    pub(super) const fn least(self, other: Self) -> Self {
        Self {
            worst: self.worst.min(other.worst),
            eighth: self.eighth.min(other.eighth),
            unsolved: self.unsolved.min(other.unsolved),
        }
    }
}

/// A state, with the exact results of each function that solves an equation.
struct State {
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
            range: Range::of(chain),
            solved,
            mass: inverts.then(|| exactly(Function::MassMatrix)),
            states: Vec::new(),
        }
    }

    /// The error in the worst of a thousand states, estimated from a few, relative to the largest result, in units of
    /// the type's roundoff. Infinite if a result is NaN.
    pub(super) fn error(&mut self, program: &Program) -> MeasuredError {
        let scalar = self.scalar;
        let mut errors: Vec<f64> = Vec::new();
        let mut results = Vec::new();
        for number in 0..STATES {
            if number == FIRST && errors.iter().all(|&error| error <= NOTHING) {
                break;
            }
            // States are made when they are first needed.
            if errors.len() == self.states.len() {
                let state = self.state(number);
                self.states.push(state);
            }
            let state = &self.states[errors.len()];
            let found = match scalar {
                Real::F32 => self.found::<Single>(program, state),
                Real::F64 | Real::Generic => self.found::<Plain>(program, state),
            };
            errors.push(self.error_of(&found, state) / scalar.roundoff());
            results.push(found);
        }
        errors.sort_by(f64::total_cmp);
        let worst = &errors[errors.len() - errors.len() / 8..];
        let mut error = MeasuredError {
            worst: TAIL * worst.iter().sum::<f64>() / worst.iter().map(|_| 1.0).sum::<f64>(),
            eighth: TAIL * worst[0],
            unsolved: 0.0,
        };
        if error.worst > ENOUGH {
            let states = results.iter().zip(&self.states);
            let unsolved = states.map(|(found, state)| self.unsolved(found, state));
            error.unsolved = largest(unsolved) / scalar.roundoff();
        }
        error
    }

    fn state(&self, number: u32) -> State {
        let arguments = arguments(self.chain, &self.range, number, self.scalar);
        let input = |input| Double::from(at(&arguments, self.chain, input));
        let exact = self.solved.iter().map(|solved| solved.exactly.at(input));
        State {
            exact: exact.collect(),
            mass: self.mass.iter().flat_map(|mass| mass.at(input)).collect(),
            arguments,
        }
    }

    /// The results of a program in a state.
    fn found<T: Rounded>(&self, program: &Program, state: &State) -> Vec<f64> {
        let at = |input| T::literal(at(&state.arguments, self.chain, input));
        let found = run::<T>(program, at);
        found.iter().map(Rounded::to_f64).collect()
    }

    /// The largest error relative to the largest result, over the functions.
    fn error_of(&self, found: &[f64], state: &State) -> f64 {
        let functions = self.solved.iter().zip(&state.exact);
        functions.fold(0.0, |worst, (solved, exact)| {
            let size = largest(exact.iter().map(|exact| exact.to_f64()));
            let errors = found[solved.place.clone()].iter().zip(exact);
            let errors = errors.map(|(&found, exact)| (Double::from(found) - *exact).to_f64());
            let error = largest(errors);
            worst.max(match size {
                // The exact result is infinite.
                f64::INFINITY => f64::INFINITY,
                // All exact results may be zero.
                _ if error == 0.0 => 0.0,
                _ => error / size / solved.allowed,
            })
        })
    }

    /// The largest entry of M M⁻¹ − I, relative to the terms of its sum, in units that make all Mᵢᵢ = 1.
    fn unsolved(&self, found: &[f64], state: &State) -> f64 {
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

/// The arguments of all functions, exact in the type of numbers, from a sequence that fills the range evenly:
/// multiples of the golden ratio and of roots. Every eighth state is near the configuration of the description, in
/// which axes and links are in line.
fn arguments(chain: &Chain, range: &Range, number: u32, scalar: Real) -> Arguments<f64> {
    let is_near = number % 8 == 7;
    let near = |&[lower, upper]: &[f64; 2]| {
        let zero = 0.0_f64.clamp(lower, upper);
        [lower, upper].map(|end| zero + NEAR * (end - zero))
    };
    let q = range.turns_with_digits();
    let q: Vec<[f64; 2]> = if is_near {
        q.iter().map(near).collect()
    } else {
        q
    };
    let step = f64::from(number + 1);
    let mut entry = 0.0_f64;
    let mut next = |[lower, upper]: [f64; 2]| {
        entry += 1.0;
        let share = 0.5 + step * 0.618_033_988_749_895 * entry.sqrt();
        Real::F32.rounded(lower + (upper - lower) * share.fract())
    };
    let mut all = |ranges: &[[f64; 2]]| ranges.iter().map(|&ends| next(ends)).collect();
    let spaces = chain.spaces();
    let mut arguments = Arguments::of(|variable| match variable {
        Variable::Q => all(&q),
        // No function that solves an equation reads accelerations; another one beside it may.
        Variable::Qdd => vec![1.0; spaces.len(variable.space())],
        Variable::Tau | Variable::Actions => {
            all(&vec![[-TORQUE, TORQUE]; spaces.len(variable.space())])
        }
        _ => all(&range.arguments[variable]),
    });
    for first in spaces.quaternions() {
        let entries = arguments[Variable::Q][first.index()..].first_chunk_mut();
        let entries: &mut [f64; 4] = entries.expect("a quaternion has four entries");
        // x, y, z, w: no rotation if all but w are zero.
        let small = if is_near { 0 } else { number % 4 };
        if is_near {
            entries[3] = 1.0;
        }
        *entries = of_length_1(*entries, small as usize, scalar);
    }
    arguments
}

fn at(arguments: &Arguments<f64>, chain: &Chain, input: Input) -> f64 {
    match input {
        Input::Variable(variable, k) => arguments[variable][usize::from(k)],
        Input::Parameter(..) => Real::F32.rounded(field(chain, input)),
    }
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

/// A type of numbers that gives the same bits on every platform.
trait Rounded: Arithmetic {
    fn to_f64(&self) -> f64;
}

/// Double precision, with correctly rounded sines.
#[derive(Clone, Copy)]
struct Plain(f64);

/// Single precision, with correctly rounded sines.
#[derive(Clone, Copy)]
struct Single(f32);

macro_rules! implement {
    ($type:ident) => {
        impl std::ops::Add for $type {
            type Output = Self;

            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }

        impl std::ops::Sub for $type {
            type Output = Self;

            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }

        impl std::ops::Mul for $type {
            type Output = Self;

            fn mul(self, other: Self) -> Self {
                Self(self.0 * other.0)
            }
        }

        impl std::ops::Div for $type {
            type Output = Self;

            fn div(self, other: Self) -> Self {
                Self(self.0 / other.0)
            }
        }

        impl std::ops::Neg for $type {
            type Output = Self;

            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl Arithmetic for $type {
            fn literal(value: f64) -> Self {
                Self(Arithmetic::literal(value))
            }

            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }

            fn sign(self) -> Self {
                Self(Arithmetic::sign(self.0))
            }

            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = Double::from(self.to_f64()).sin_cos();
                (Self::literal(sine.to_f64()), Self::literal(cosine.to_f64()))
            }
        }

        impl Rounded for $type {
            fn to_f64(&self) -> f64 {
                self.0.into()
            }
        }
    };
}

implement!(Plain);
implement!(Single);
