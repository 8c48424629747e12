//! Robots and states that are hard on arithmetic.
//!
//! In: the labels of the hard robots of the tests. Out: of a function there, in a formulation, the worst
//! error in units of rounding, in relation to the magnitudes that [`crate::truth`] has; [`formulations`]
//! and [`functions`] lay these out. Programs are run as they stand, in `f64` or `f32`, without fusing; the
//! tests hold the same cases to limits against 256 bits.

pub mod formulations;
pub mod functions;

use homogen_codegen::chain::Chain;
use homogen_codegen::expand::program_as;
use homogen_codegen::expression::{Arithmetic, Evaluation, Expr, Input, Term};
use homogen_codegen::formulation::Formulation;
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::list::Id;
use homogen_codegen::model::Way;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::{FrameId, Space, Variable};
use homogen_codegen::{Function, Real};
use homogen_random::Random;
use homogen_tests::subjects::subject;

use crate::truth::{Exact, exact};

/// A robot, and what is hard about its states.
#[derive(Clone, Copy)]
pub struct Hard {
    /// What readers call it.
    pub title: &'static str,
    label: &'static str,
    /// Changes a number in [−1, 1) into a coordinate.
    angle: fn(f64) -> f64,
    /// The same for a rate.
    rate: fn(f64) -> f64,
    /// How far away a base is that is free, in metres; none is where there is no such number.
    free: Option<f64>,
}

impl Hard {
    /// One in any states.
    pub const fn new(title: &'static str, label: &'static str) -> Self {
        Self {
            title,
            label,
            angle: |x| 4.0 * x,
            rate: |x| 2.0 * x,
            free: None,
        }
    }

    /// One whose angles are these.
    pub const fn at(self, angle: fn(f64) -> f64) -> Self {
        Self { angle, ..self }
    }

    /// One whose rates are these.
    pub const fn moving(self, rate: fn(f64) -> f64) -> Self {
        Self { rate, ..self }
    }

    /// One whose base is free, and so far away.
    pub const fn free(self, metres: f64) -> Self {
        let free = Some(metres);
        Self { free, ..self }
    }
}

/// Nearly straight.
pub const STRAIGHT: fn(f64) -> f64 = |x| x / 1024.0;
/// Up to 10⁵ rad, near quarter turns.
pub const MANY_TURNS: fn(f64) -> f64 = |x| (1e5 * x).round() * std::f64::consts::FRAC_PI_2;
/// Up to 10⁴ rad/s.
pub const FAST: fn(f64) -> f64 = |x| 8192.0 * x;

/// What a function of a robot should return in hard states, as a type of number has them.
pub struct Truth {
    chain: Chain,
    function: Function,
    scalar: Real,
    /// q, q̇, q̈ and τ of each, exact in the type.
    states: Vec<Vec<f64>>,
    /// High part, low part and magnitude of each result.
    results: Vec<Vec<[f64; 3]>>,
}

impl Truth {
    /// Computes it in so many states.
    pub fn of(hard: &Hard, function: Function, scalar: Real, states: usize) -> Self {
        let mut subject = subject(hard.label);
        subject.request.floating = hard.free.is_some();
        let chain = subject.chain();
        let states = hard.states(&chain, scalar, states);
        let graph = chain.graph.clone();
        let bodies = arrange(&graph, &chain, Layout::DESCRIBED);
        let results = function.build(&graph, &bodies, FrameId::FIRST, Way::PLAIN);
        let results: Vec<Expr> = results.into_iter().map(Term::expr).collect();
        let evaluation: Evaluation<Exact> = Evaluation::of(&graph, &results);
        let coordinates = chain.spaces().len(Space::Coordinates);
        let results = states
            .iter()
            .map(|state| exact(&evaluation, function, coordinates, state));
        Self {
            results: results.collect(),
            chain,
            function,
            scalar,
            states,
        }
    }

    /// The worst error in units of rounding of the type, of what is not refused.
    pub fn worst(&self, formulation: Formulation) -> Option<f64> {
        let (function, frame) = ([self.function], FrameId::FIRST);
        let program = program_as(formulation, &self.chain, &function, frame, self.scalar);
        let program = program.ok()?;
        Some(match self.scalar {
            Real::F32 => self.worst_in::<f32>(&program) / 2_f64.powi(-24),
            _ => self.worst_in::<f64>(&program) / 2_f64.powi(-53),
        })
    }

    fn worst_in<T: Arithmetic + Into<f64>>(&self, program: &Program) -> f64 {
        let spaces = self.chain.spaces();
        let [coordinates, velocities] =
            [Space::Coordinates, Space::Velocities].map(|space| spaces.len(space));
        let error = |(state, exact): (&Vec<f64>, &Vec<[f64; 3]>)| {
            let found = run(program, |input| {
                T::literal(match input {
                    Input::Variable(Variable::Q, k) => state[usize::from(k)],
                    // A state lists the others in their order.
                    Input::Variable(variable, k) => {
                        let before = coordinates + (variable as usize - 1) * velocities;
                        state[before + usize::from(k)]
                    }
                    Input::Parameter(..) => unreachable!("no number was left open"),
                })
            });
            let errors = found.into_iter().zip(exact);
            let errors = errors.map(|(found, [high, low, magnitude])| {
                let found: f64 = found.into();
                let distance = (found - high - low).abs();
                // What is always nothing has no magnitude.
                if distance == 0.0 {
                    0.0
                } else {
                    distance / magnitude
                }
            });
            errors.fold(0.0, worse)
        };
        let states = self.states.iter().zip(&self.results);
        states.map(error).fold(0.0, worse)
    }
}

impl Hard {
    /// Numbers that are exact in single precision, so that both types see the same; but for quaternions, which have
    /// unit length in the type that sees them.
    fn states(&self, chain: &Chain, scalar: Real, count: usize) -> Vec<Vec<f64>> {
        let mut random = Random::new(1);
        let changes: [fn(f64) -> f64; 4] = [self.angle, self.rate, |x| 8.0 * x, |x| 16.0 * x];
        let spaces = chain.spaces();
        let [coordinates, velocities] =
            [Space::Coordinates, Space::Velocities].map(|space| spaces.len(space));
        let lengths = [coordinates, velocities, velocities, velocities];
        let mut state = || {
            let numbers = changes.iter().zip(lengths);
            let numbers = numbers.flat_map(|(change, length)| std::iter::repeat_n(change, length));
            let numbers = numbers.map(|change| change(f64::from(random.coarse())));
            let mut numbers: Vec<f64> = numbers.collect();
            if let Some(metres) = self.free {
                for place in &mut numbers[..3] {
                    *place *= metres;
                }
            }
            let mut numbers: Vec<f64> = numbers.into_iter().map(single).collect();
            for place in spaces.quaternions() {
                let quaternion = &mut numbers[place.index()..][..4];
                let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
                for entry in quaternion {
                    *entry /= length;
                    if scalar == Real::F32 {
                        *entry = single(*entry);
                    }
                }
            }
            numbers
        };
        (0..count).map(|_| state()).collect()
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding is what is asked for"
)]
fn single(number: f64) -> f64 {
    f64::from(number as f32)
}

/// The larger; what is no number counts as infinite.
fn worse(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}
