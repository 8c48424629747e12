//! Collision spheres by dense matrices: centres, distances, and their derivatives.
//!
//! In: a robot at a state. Out: values, all in frame 0: a centre moves by the velocity L P at a unit velocity of each
//! joint that carries it.

use super::{Approximate, Dense, Matrix};
use crate::expression::Arithmetic;
use crate::list::List;
use crate::space::{SphereId, VelocityId};

impl Dense {
    /// The centres of all spheres.
    pub(crate) fn sphere_centers(&self) -> Vec<Approximate> {
        let spheres = self.configuration.spheres().ids();
        spheres.flat_map(|k| self.center(k)).collect()
    }

    /// The distances of all pairs.
    pub(crate) fn distances(&self) -> Vec<Approximate> {
        let pairs = self.configuration.pairs().iter();
        let distances = pairs.map(|&[a, b]| {
            let radii = [a, b].map(|k| self.configuration.spheres()[k].1);
            let (_, length) = self.normal([a, b]);
            length - radii[0] - radii[1]
        });
        distances.collect()
    }

    /// Their derivatives, a row for each pair.
    pub(crate) fn distance_jacobian(&self) -> Vec<Approximate> {
        let pairs = self.configuration.pairs().iter();
        pairs.flat_map(|&pair| self.change(pair)).collect()
    }

    fn change(&self, [a, b]: [SphereId; 2]) -> List<VelocityId, Approximate> {
        let nothing = Approximate::exact(0.0);
        let mut row = List::filled(nothing, self.state.velocities());
        let (normal, _) = self.normal([a, b]);
        for (k, sign) in [(a, 1.0), (b, -1.0)] {
            let (frame, _) = self.configuration.spheres()[k];
            let center = Matrix::translation(self.center(k));
            for (velocity, screw) in self.configuration.moving(frame) {
                let moved = screw.times(&center).column();
                let along = normal.iter().zip(moved).map(|(&n, v)| n * v);
                let along = along.fold(nothing, |sum, term| sum + term);
                row[*velocity] = row[*velocity] + along * Approximate::exact(sign);
            }
        }
        row
    }

    /// The direction from the second centre to the first, and their distance.
    fn normal(&self, [a, b]: [SphereId; 2]) -> ([Approximate; 3], Approximate) {
        let (first, second) = (self.center(a), self.center(b));
        let offset: [Approximate; 3] = std::array::from_fn(|k| first[k] - second[k]);
        let square = offset.iter().map(|&entry| entry * entry);
        let square = square.fold(Approximate::exact(0.0), |sum, term| sum + term);
        let length = square.sqrt();
        (offset.map(|entry| entry / length), length)
    }

    fn center(&self, k: SphereId) -> [Approximate; 3] {
        self.pose(self.configuration.spheres()[k].0).column()
    }
}
