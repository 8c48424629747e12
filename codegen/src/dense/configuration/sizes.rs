//! Sizes of the terms of the regressor's entries.
//!
//! In: a configuration, q̇ and q̈. Out: for each parameter and velocity the product of the lengths of the vectors whose
//! components the entry is made of. Lengths do not grow with the number of rotations of a frame, as sums of magnitudes
//! would, so that they stay in proportion to rounding errors.

use super::{Approximate, Configuration, MOMENTS, Rates};
use crate::dense::{BodyId, Columns, Matrix};
use crate::list::{Id, List};
use crate::space::{ParameterId, VelocityId};

/// Lengths of the parts of L, of the terms of W or of those of H.
#[derive(Clone, Copy, Default)]
struct Lengths {
    angular: f64,
    linear: f64,
}

impl Lengths {
    fn of(screw: &Matrix<Approximate>) -> Self {
        let [x, y, z, a, b, c] = screw.vectors().map(Approximate::to_f64);
        let length = |x: f64, y: f64, z: f64| (x * x + y * y + z * z).sqrt();
        Self {
            angular: length(x, y, z),
            linear: length(a, b, c),
        }
    }

    fn times(self, factor: f64) -> Self {
        Self {
            angular: factor * self.angular,
            linear: factor * self.linear,
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            angular: self.angular + other.angular,
            linear: self.linear + other.linear,
        }
    }

    /// The lengths about a reference point at a distance from the origin.
    fn at(self, distance: f64) -> Self {
        Self {
            angular: self.angular,
            linear: self.linear + self.angular * distance,
        }
    }
}

impl Configuration {
    /// The sizes of the entries of the regressor's columns; links without a wanted column have empty ones.
    pub(in crate::dense) fn regressor_sizes(
        &self,
        rates: &Rates,
        is_wanted: impl Fn(ParameterId) -> bool,
    ) -> Columns<f64> {
        let accelerations = self.acceleration_lengths(rates);
        let mut columns: Columns<f64> = List::new();
        for &link in &self.robot.links {
            if !(0..MOMENTS).any(|moment| is_wanted(columns.next().plus(moment))) {
                columns.extend((0..MOMENTS).map(|_| List::new()));
                continue;
            }
            let [x, y, z] = self.poses[link].column().map(Approximate::to_f64);
            let distance = (x * x + y * y + z * z).sqrt();
            let h = accelerations[link].at(distance);
            // For m, for each entry of q and for each entry of J.
            let mut sizes = [(); 3].map(|()| self.nothing().map(|_| 0.0));
            for body in self.inwards(link) {
                for (velocity, screw) in &self.screws[body] {
                    let l = Lengths::of(screw).at(distance);
                    sizes[0][*velocity] += h.linear * l.linear;
                    sizes[1][*velocity] += h.linear * l.angular + h.angular * l.linear;
                    sizes[2][*velocity] += h.angular * l.angular;
                }
            }
            for (sizes, count) in sizes.iter().zip([1, 3, 6]) {
                columns.extend(std::iter::repeat_n(sizes.clone(), count));
            }
        }
        let actuators = self.regressor_of_actuators(rates);
        columns.extend(
            actuators
                .iter()
                .map(|column| column.map(|entry| entry.size())),
        );
        columns
    }

    /// Lengths of the terms of H − H_g, for each body.
    fn acceleration_lengths(&self, rates: &Rates) -> List<BodyId, Lengths> {
        let gravity = self.gravity().map(Approximate::to_f64);
        let gravity = gravity
            .iter()
            .map(|entry| entry * entry)
            .sum::<f64>()
            .sqrt();
        let mut motions: List<BodyId, [Lengths; 2]> = List::new();
        for (body, screws) in self.robot.bodies.iter().zip(&self.screws) {
            let rest = [
                Lengths::default(),
                Lengths {
                    angular: 0.0,
                    linear: gravity,
                },
            ];
            let [w, h] = body.parent.map_or(rest, |parent| motions[parent]);
            let sum = |of: &List<VelocityId, Approximate>| {
                let terms = screws.iter();
                let terms = terms.map(|(k, screw)| Lengths::of(screw).times(of[*k].size()));
                terms.fold(Lengths::default(), Lengths::plus)
            };
            let (own, second) = (sum(&rates.first), sum(&rates.second));
            let squares = own.times(own.angular).plus(own.times(2.0 * w.angular));
            motions.push([w.plus(own), h.plus(second).plus(squares)]);
        }
        motions.map(|[_, h]| *h)
    }
}
