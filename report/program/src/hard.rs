//! Rounding errors of robots and states with difficult numbers.
//!
//! In: the labels of the hard robots of the tests. Out: the worst error of a function in a formulation, in units of
//! rounding, relative to the magnitudes of [`crate::truth`]; [`formulations`] and [`functions`] make tables of these.
//! Programs are interpreted in `f64` or `f32`, without fused operations. The tests compare the same cases with 256 bits.

pub mod formulations;
pub mod functions;

use homogen_codegen::chain::Chain;
use homogen_codegen::expression::Arithmetic;
use homogen_codegen::formulation::Formulation;
use homogen_codegen::schedule::{Program, run};
use homogen_codegen::space::{FrameId, Space};
use homogen_codegen::{Function, Real};
use homogen_random::Random;
use homogen_tests::programs::program_as;
use homogen_tests::subjects::subject;

use crate::states::{in_single_precision, normalize_quaternions, single};
use crate::truth::{evaluation, exact, given};

/// A robot with difficult states.
#[derive(Clone, Copy)]
pub struct Hard {
    /// Its title in the report.
    pub title: &'static str,
    label: &'static str,
    /// Changes a number in [−1, 1) into a coordinate.
    angle: fn(f64) -> f64,
    /// The same for a rate.
    rate: fn(f64) -> f64,
    /// The scale of the position of a floating base \[m\]; `None` for a fixed base.
    floating: Option<f64>,
}

impl Hard {
    /// A robot in ordinary states.
    pub const fn new(title: &'static str, label: &'static str) -> Self {
        Self {
            title,
            label,
            angle: |x| 4.0 * x,
            rate: |x| 2.0 * x,
            floating: None,
        }
    }

    /// The same with these angles.
    pub const fn at(self, angle: fn(f64) -> f64) -> Self {
        Self { angle, ..self }
    }

    /// The same with these rates.
    pub const fn moving(self, rate: fn(f64) -> f64) -> Self {
        Self { rate, ..self }
    }

    /// The same with a floating base at distances up to `metres`.
    pub const fn floating(self, metres: f64) -> Self {
        let floating = Some(metres);
        Self { floating, ..self }
    }
}

/// Nearly straight.
pub const STRAIGHT: fn(f64) -> f64 = |x| x / 1024.0;
/// Up to 10⁵ rad, near quarter turns.
pub const MANY_TURNS: fn(f64) -> f64 = |x| (1e5 * x).round() * std::f64::consts::FRAC_PI_2;
/// Up to 10⁴ rad/s.
pub const FAST: fn(f64) -> f64 = |x| 8192.0 * x;

impl Hard {
    /// q, q̇, q̈ and τ of `count` states, one after the other. They are exact in both types, except for quaternions, which
    /// have unit length here.
    fn states(&self, chain: &Chain, count: usize) -> Vec<f64> {
        let mut random = Random::new(1);
        let changes: [fn(f64) -> f64; 4] = [self.angle, self.rate, |x| 8.0 * x, |x| 16.0 * x];
        let spaces = chain.spaces();
        let [coordinates, velocities] =
            [Space::Coordinates, Space::Velocities].map(|space| spaces.len(space));
        let lengths = [coordinates, velocities, velocities, velocities];
        let mut states = Vec::new();
        for _ in 0..count {
            let start = states.len();
            for (change, length) in changes.into_iter().zip(lengths) {
                states.extend((0..length).map(|_| change(f64::from(random.coarse()))));
            }
            let state = &mut states[start..];
            if let Some(metres) = self.floating {
                for place in &mut state[..3] {
                    *place *= metres;
                }
            }
            for number in &mut *state {
                *number = single(*number);
            }
            normalize_quaternions(spaces, state);
        }
        states
    }
}

/// The exact results of a function of a robot in difficult states.
pub struct Truth {
    chain: Chain,
    function: Function,
    states: Vec<State>,
    /// The states rounded to single precision, if they differ.
    in_single: Option<Vec<State>>,
}

/// A state, and high part, low part and magnitude of each result there.
struct State {
    numbers: Vec<f64>,
    results: Vec<[f64; 3]>,
}

impl Truth {
    /// Computes the exact results in `count` states.
    pub fn of(hard: &Hard, function: Function, count: usize) -> Self {
        let mut subject = subject(hard.label);
        subject.request.floating = hard.floating.is_some();
        let chain = subject.chain();
        let evaluation = evaluation(&chain, function);
        let coordinates = chain.spaces().len(Space::Coordinates);
        let states = hard.states(&chain, count);
        let length = states.len() / count;
        let with_results = |states: &[f64]| -> Vec<State> {
            let states = states.chunks(length).map(|numbers| State {
                results: exact(&evaluation, function, coordinates, numbers),
                numbers: numbers.to_vec(),
            });
            states.collect()
        };
        Self {
            states: with_results(&states),
            in_single: in_single_precision(&states).as_deref().map(with_results),
            chain,
            function,
        }
    }

    /// The worst error in units of rounding of a type; `None` if the engine rejects the formulation.
    pub fn worst(&self, formulation: Formulation, scalar: Real) -> Option<f64> {
        let (function, frame) = ([self.function], FrameId::FIRST);
        let program = program_as(formulation, &self.chain, &function, frame, scalar);
        let program = program.ok()?;
        Some(match scalar {
            Real::F32 => {
                let states = self.in_single.as_ref().unwrap_or(&self.states);
                self.worst_in::<f32>(&program, states) / 2_f64.powi(-24)
            }
            _ => self.worst_in::<f64>(&program, &self.states) / 2_f64.powi(-53),
        })
    }

    fn worst_in<T: Arithmetic + Into<f64>>(&self, program: &Program, states: &[State]) -> f64 {
        let coordinates = self.chain.spaces().len(Space::Coordinates);
        let error = |state: &State| {
            let found = run(program, |input| {
                T::literal(given(&state.numbers, coordinates, input))
            });
            let errors = found.into_iter().zip(&state.results);
            let errors = errors.map(|(found, [high, low, magnitude])| {
                let found: f64 = found.into();
                let distance = (found - high - low).abs();
                // An entry that is always zero has no magnitude.
                if distance == 0.0 {
                    0.0
                } else {
                    distance / magnitude
                }
            });
            errors.fold(0.0, worse)
        };
        states.iter().map(error).fold(0.0, worse)
    }
}

/// The larger; infinite for NaN.
fn worse(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}
