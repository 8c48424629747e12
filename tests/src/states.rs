//! Random states that are the same on every machine.
//!
//! In: a sequence of random numbers. Out: states made of it. All numbers of a state are multiples of
//! 2⁻²¹ below 4, so that `f32` holds them exactly and a function's error is not that of its arguments.

use std::array::from_fn;

use homogen::{Chain, Scalar};
pub use homogen_random::Random;

/// What no sensor should say, to take the place of some entries of a random state; every type of number
/// has each of them.
pub const NASTY: [f32; 14] = [
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::MAX,
    -1e30,
    1e10,
    -3.0e6,
    3201.0,
    -3200.0,
    1e-30,
    f32::MIN_POSITIVE,
    1e-40,
    -0.0,
    0.0,
];

/// A state of a robot with N velocities and Q coordinates.
#[derive(Clone, Copy, Debug)]
pub struct State<T, const N: usize, const Q: usize = N> {
    /// Coordinates [rad, m or 1].
    pub q: [T; Q],
    /// Velocities.
    pub qd: [T; N],
    /// Accelerations.
    pub qdd: [T; N],
}

impl<const N: usize> State<f64, N> {
    /// A state with all entries in [−4, 4): every angle, and more than a turn.
    pub fn random(random: &mut Random) -> Self {
        let mut vector = || from_fn(|_| 4.0 * random.unit());
        Self {
            q: vector(),
            qd: vector(),
            qdd: vector(),
        }
    }
}

impl<const N: usize, const Q: usize> State<f64, N, Q> {
    /// The same of a robot with quaternions, which have length 1 to rounding and are no such multiples.
    pub fn of<const F: usize, const B: usize>(
        chain: &Chain<N, F, Q, B>,
        random: &mut Random,
    ) -> Self {
        Self {
            q: chain.normalize(&from_fn(|_| 4.0 * random.unit())),
            qd: from_fn(|_| 4.0 * random.unit()),
            qdd: from_fn(|_| 4.0 * random.unit()),
        }
    }

    /// The same state in another type of number.
    #[must_use]
    pub fn to<T: Scalar>(&self) -> State<T, N, Q> {
        State {
            q: self.q.map(T::constant),
            qd: self.qd.map(T::constant),
            qdd: self.qdd.map(T::constant),
        }
    }
}
