//! Random states that are the same on every machine.
//!
//! In: a sequence of random numbers. Out: states made of it. All numbers of a state are multiples of
//! 2⁻²¹ below 4, so that `f32` holds them exactly and a function's error is not that of its arguments.

use std::array::from_fn;

use homogen::Scalar;
pub use homogen_random::Random;

/// A state of a robot with N joints.
#[derive(Clone, Copy, Debug)]
pub struct State<T, const N: usize> {
    /// Coordinates [rad or m].
    pub q: [T; N],
    /// Their rates.
    pub qd: [T; N],
    /// Their second rates.
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

    /// The same state in another type of number.
    #[must_use]
    pub fn to<T: Scalar>(&self) -> State<T, N> {
        State {
            q: self.q.map(T::constant),
            qd: self.qd.map(T::constant),
            qdd: self.qdd.map(T::constant),
        }
    }
}
