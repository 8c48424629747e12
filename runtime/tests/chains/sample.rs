//! Random chains and states from a fixed seed, and the comparison of arrays of numbers.

use homogen::{Action, Chain, Frame, Inertia, Joint, Pose, Real, Screw, rotation, vector};
use std::array::from_fn;

/// Random numbers, vectors, poses, screws, inertias and chains.
pub struct Random(homogen_random::Random);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(homogen_random::Random::new(seed))
    }

    /// In (−1, 1), and never zero.
    pub fn number<T: Real>(&mut self) -> T {
        T::constant(self.0.odd())
    }

    pub fn numbers<T: Real, const N: usize>(&mut self) -> [T; N] {
        from_fn(|_| self.number())
    }

    pub fn unit(&mut self) -> [f64; 3] {
        loop {
            let v: [f64; 3] = self.numbers();
            if vector::dot(v, v) > 0.01 {
                return vector::unit(v).expect("not zero");
            }
        }
    }

    pub fn pose(&mut self) -> Pose<f64> {
        let angle = 3.2 * self.number::<f64>();
        Pose::new(
            rotation::from_axis_angle(self.unit(), angle),
            self.numbers(),
        )
    }

    /// A revolute, prismatic or screw pair, by `kind` modulo 3.
    pub fn screw(&mut self, kind: usize) -> Screw<f64> {
        match kind % 3 {
            0 => Screw::revolute(self.unit(), self.numbers()),
            1 => Screw::prismatic(self.unit()),
            _ => Screw::helical(self.unit(), self.numbers(), self.number()),
        }
    }

    /// A body of several particles.
    pub fn inertia(&mut self) -> Inertia<f64> {
        (0..6).fold(Inertia::zero(), |j, _| {
            let mass = self.number::<f64>().abs();
            j + Inertia::of_particle(mass, self.numbers())
        })
    }

    /// A tree of seven joints of all types; every third seed gives one without branches.
    pub fn chain(&mut self) -> Chain<7, 1> {
        let branched = !self.0.chance(3);
        let joints = from_fn(|i| {
            let parent = i.checked_sub(if branched && i == 4 { 3 } else { 1 });
            let (placement, inertia) = (self.pose(), self.inertia());
            Joint::new("joint", parent, placement, self.screw(i), inertia)
        });
        let tip = Frame::new("tip", Some(6), self.pose());
        Chain::new(joints, [tip], self.numbers::<f64, 3>().map(|g| 9.81 * g))
    }

    pub fn actions<T: Real, const N: usize>(&mut self) -> [Action<T>; N] {
        from_fn(|_| Action::new(self.numbers(), self.numbers()))
    }
}

/// Asserts that all entries of `a` and `b` agree to `units` of rounding times `size`.
#[track_caller]
pub fn agree<T: Real>(a: &[T], b: &[T], units: f64, size: f64) {
    assert_eq!(a.len(), b.len());
    let bound = units * 0.5 * T::EPSILON.to_f64() * size;
    for (x, y) in a.iter().zip(b) {
        let error = (*x - *y).abs().to_f64();
        assert!(
            error <= bound,
            "{a:?}\nbut\n{b:?}\nby {error:e} > {bound:e}"
        );
    }
}

/// The largest magnitude of the entries.
pub fn largest<T: Real>(entries: &[T]) -> f64 {
    entries.iter().fold(0.0, |m, x| m.max(x.abs().to_f64()))
}
