//! Random states that are the same on every machine.
//!
//! In: a sequence of random numbers. Out: states. All entries are multiples of 2⁻²¹ below 4, exact in `f32`, so that
//! arguments have no error.

use std::array::from_fn;

use homogen::{Chain, Scalar};
pub use homogen_random::Random;

/// Values that a sensor may give by mistake, for some entries of a random state; all are exact in every tested type.
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
    /// A state with all entries in [−4, 4), which includes every angle.
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
    /// A state of a robot with quaternions, which are normalised and so not exact in `f32`.
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
