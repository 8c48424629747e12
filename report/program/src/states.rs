//! Random states of a robot.
//!
//! In: the lists of its coordinates and velocities, and limits. Out: q, q̇, q̈ and τ of each state, one after the other.
//! Their numbers are exact in single precision, so that both types have the same states; quaternions are the exception,
//! they have unit length in each type.

use homogen_codegen::list::Id;
use homogen_codegen::space::{Space, Spaces};
use homogen_random::Random;

use crate::simplified;

/// Number of states for times and errors of a function.
pub const STATES: usize = 1024;

/// Limits of random coordinates, rates, second rates and torques, and the joints that have any.
#[derive(Clone, Copy)]
pub struct Range {
    limits: [f64; 4],
    moves: fn(usize) -> bool,
}

impl Range {
    /// Any motion.
    pub const WIDE: Self = Self {
        limits: [4.0, 2.0, 8.0, 16.0],
        moves: |_| true,
    };
    /// Any motion at less than 1/100 of the speed.
    pub const SLOW: Self = Self {
        limits: [4.0, 2.0 / 128.0, 8.0 / 128.0, 16.0],
        moves: |_| true,
    };
    /// Motion of the joints that move an arm within a plane.
    pub const PLANE: Self = Self {
        moves: |joint| simplified::PLANE.contains(&joint),
        ..Self::WIDE
    };
}

/// Random states of a robot: the numbers of [`STATES`] states.
pub fn states(spaces: &Spaces, range: Range) -> Vec<f64> {
    let mut random = Random::new(1);
    let mut states = Vec::new();
    for _ in 0..STATES {
        let start = states.len();
        let lists = [Space::Coordinates, Space::Velocities].map(|space| spaces.len(space));
        let [coordinates, velocities] = lists;
        let lengths = [coordinates, velocities, velocities, velocities];
        for (limit, length) in range.limits.into_iter().zip(lengths) {
            states.extend((0..length).map(|joint| {
                let number = limit * f64::from(random.coarse());
                if (range.moves)(joint) { number } else { 0.0 }
            }));
        }
        normalize_quaternions(spaces, &mut states[start..]);
    }
    states
}

/// Normalizes the quaternions of a state.
pub fn normalize_quaternions(spaces: &Spaces, state: &mut [f64]) {
    for place in spaces.quaternions() {
        let quaternion = &mut state[place.index()..][..4];
        let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
        for entry in quaternion {
            *entry /= length;
        }
    }
}

/// The states rounded to single precision; `None` if they are the same.
pub fn in_single_precision(states: &[f64]) -> Option<Vec<f64>> {
    let seen: Vec<f64> = states.iter().copied().map(single).collect();
    (seen != states).then_some(seen)
}

/// The nearest number of single precision.
#[expect(clippy::cast_possible_truncation, reason = "rounding is the purpose")]
pub fn single(number: f64) -> f64 {
    f64::from(number as f32)
}
