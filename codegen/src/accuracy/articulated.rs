//! Error bounds of the articulated-body algorithm: accelerations, the inverse of the mass matrix, and derivatives
//! made with it.
//!
//! In: a chain, in the layout and by the algorithm of the function. Out: the backward error of accelerations, as
//! torques and forces, and the error of entries of the inverse. Screw joints and inertias known at run time only are
//! not covered. Every constant is derived below.
//!
#![doc = include_str!("articulated.md")]

mod inertias;
mod inverse;
mod recursion;
mod sizes;
#[cfg(test)]
mod tests;

pub use self::recursion::Articulated;

use self::inertias::{FROBENIUS, Outboard, TRUST, errors};
use self::recursion::RoundedRecursion;
use self::sizes::Pair;
use super::error_bounds::{Accuracy, Perturbed, RoundingModel, Worst, backward, computed, values};
use super::free_fall;
use super::solved::{
    UNCERTAIN, caused, largest, largest_of_rows, stays, tried, underflow, widened,
};
use crate::chain::BodyId;
use crate::list::List;
use crate::model::ARTICULATED_MOTION;
use crate::range::Range;
use crate::schedule::Program;
use crate::schedule::bound::{self, Value};
use crate::space::Variable;

/// The least margin that is tried. A smaller one would improve a bound by less than a thousandth.
const LEAST_MARGIN: f64 = 1e-3;

impl Articulated<'_> {
    /// Bounds the backward error of accelerations, as torques and forces.
    #[must_use]
    pub fn accelerations(&self, rounding: RoundingModel) -> Accuracy {
        let programs: [&Program; 2] = [&self.programs.motion, &self.fall];
        backward(
            self.chain,
            Perturbed::Torques,
            &programs,
            rounding,
            |scalar| {
                let recursion = RoundedRecursion::of(self, rounding, scalar)?;
                tried(LEAST_MARGIN, |margin| {
                    let mut errors = recursion.torques(margin)?;
                    let lost = recursion.fall.lost(&widened(&recursion.range, margin));
                    recursion.add_fallen(&mut errors, &lost);
                    Ok(errors)
                })
            },
        )
    }

    /// Bounds the derivatives of accelerations by coordinates and velocities: the error of the derivatives of τ, at the
    /// accelerations found, which a program computes. The error of the factor M⁻¹ comes on top.
    #[must_use]
    pub fn derivatives(&self, derivatives: &Program, rounding: RoundingModel) -> Accuracy {
        let programs: [&Program; 3] = [&self.programs.motion, derivatives, &self.fall];
        let perturbed = Perturbed::TorqueDerivatives;
        backward(self.chain, perturbed, &programs, rounding, |scalar| {
            let recursion = RoundedRecursion::of(self, rounding, scalar)?;
            tried(LEAST_MARGIN, |margin| {
                recursion.torques(margin)?;
                let wider = widened(&recursion.range, margin);
                let found = values(computed(derivatives, &wider, rounding, scalar))?;
                // The underflow of an acceleration, times the inertias, is a torque.
                let most = largest(found.iter().map(|value| value.reach() + value.error));
                let size = most * recursion.mobility() * recursion.inertia() * recursion.inertia();
                let vanishes = underflow(size, self.links.len(), scalar)?;
                let roots = recursion.roots_of_masses();
                let sizes = recursion.derivatives(&found);
                let lost = recursion.fall.lost_in_derivatives(&sizes);
                let fallen =
                    free_fall::torques(&lost, roots.len(), |row, of| roots[row] * roots[of]);
                let errors = found.iter().zip(fallen);
                Ok(errors
                    .map(|(value, fallen)| value.error + vanishes + fallen)
                    .collect())
            })
        })
    }
}

impl RoundedRecursion<'_, '_> {
    /// The backward error of accelerations, as torques and forces, if these stay in their range, widened by a margin.
    fn torques(&self, margin: f64) -> Worst {
        let Articulated {
            links, mobility, ..
        } = self.bodies;
        let wider = widened(&self.range, margin);
        let found = values(computed(
            &self.bodies.programs.motion,
            &wider,
            self.rounding,
            self.scalar,
        ))?;
        let motions = found.chunks(ARTICULATED_MOTION).map(MotionSizes::of);
        let motions: List<BodyId, MotionSizes> = motions.collect();
        // Reported last: a size that rounding leaves without bound may overflow as well.
        let underflows = underflow(self.size(&motions, &wider), links.len(), self.scalar);
        let errors = self.torque_errors(&motions, &wider, underflows.unwrap_or(0.0))?;
        let off = caused(&mobility.joints, &errors);
        if stays(&self.range, margin, &off) {
            underflows.map(|_| errors)
        } else {
            Err(UNCERTAIN)
        }
    }

    /// Adds the torques of the errors of a free fall.
    fn add_fallen(&self, errors: &mut [f64], lost: &[f64]) {
        let roots = self.roots_of_masses();
        let all: f64 = roots.iter().zip(lost).map(|(root, lost)| root * lost).sum();
        for (error, root) in errors.iter_mut().zip(roots) {
            *error += root * all;
        }
    }

    /// The largest magnitudes of each row of the derivatives of accelerations, for derivatives of torques by rows:
    /// twice those of exact ones, as for [`solved`](super::solved).
    fn derivatives(&self, found: &[Value]) -> Vec<f64> {
        let mobility = &self.bodies.mobility.joints;
        let most = largest_of_rows(found, mobility.len());
        caused(mobility, &most).iter().map(|x| 2.0 * x).collect()
    }

    /// A bound of every intermediate product, from the sizes of its factors.
    fn size(&self, motions: &[MotionSizes], range: &Range) -> f64 {
        let moving = largest(motions.iter().flat_map(|motion| {
            let parts = [motion.action, motion.drift, motion.acceleration];
            parts.map(|[size, _]| size.largest())
        }));
        let most = largest(range.arguments[Variable::Qdd].iter().map(|[_, most]| *most));
        self.inertia() * self.inertia() * moving * most * self.mobility()
    }

    /// The error of the torque or force at each joint, from all roundings.
    fn torque_errors(
        &self,
        motions: &List<BodyId, MotionSizes>,
        range: &Range,
        vanishes: f64,
    ) -> Worst {
        let (links, outboard) = (&self.bodies.links, &self.outboard);
        let roundoff = self.scalar.roundoff();
        // For each body with all outboard of it: the moment and force that act on it, and their errors,
        // accumulated from its children.
        let mut forces = List::filled(Pair::default(), links.len());
        let mut lost = forces.clone();
        // The error of the joint's own terms.
        let mut beside = List::filled(0.0, links.len());
        for (k, link) in links.numbered().rev() {
            let MotionSizes {
                action: [action_size, action_lost],
                drift: [drift, drift_lost],
                acceleration: [acceleration, acceleration_lost],
            } = motions[k];
            let Outboard {
                whole, children, ..
            } = outboard[k];
            let own = Pair::new(link.spread, link.mass).roots();
            let [_, most] = range.of_velocity(Variable::Qdd, link.velocity);
            let opposed = whole.dot(acceleration);
            let free = opposed + most * link.share(whole);
            // |y|/√D: an armature opposes the joint's own acceleration.
            let right_side = opposed + most * link.armature.sqrt();
            let by_own = own.times(own.dot(acceleration));
            forces[k] = forces[k].plus(action_size).plus(by_own);

            // The joint's own equation, in units of √D.
            let has_armature = link.armature > 0.0;
            let roundings = if has_armature { 14.0 } else { 12.0 };
            let residual = roundings * roundoff * free + whole.dot(acceleration_lost);
            beside[k] = (link.share(whole) - link.along(whole)) * residual;
            let resistance = link.resistance(range.of_velocity(Variable::Qd, link.velocity));
            if resistance > 0.0 {
                let given = link.along(forces[k]) + link.armature * most;
                beside[k] += roundoff * (3.0 * resistance + given) + vanishes;
            }

            // The body's own force; its sums with those of its children; the joint's acceleration.
            let sums = forces[k].plus(whole.times((1.0 + FROBENIUS) * opposed));
            lost[k] = lost[k]
                .plus(action_lost)
                .plus(by_own.times(3.0 * roundoff))
                .plus(sums.times(children * roundoff))
                .plus(whole.times(residual))
                .plus(Pair::both(vanishes));

            let Some(parent) = link.parent else {
                continue;
            };
            // The force passed on to the parent: the drift's, the joint's, and their sum with the rest.
            let drifting = whole.dot(drift);
            let rest = forces[k].plus(whole.times(opposed + right_side + drifting));
            // A joint without armature makes one column of the inertia zero.
            let entries = if has_armature { 7.0 } else { 6.0 };
            let products = roundoff * ((entries * FROBENIUS + 3.0) * drifting + 4.0 * right_side);
            let rest_lost = whole
                .times(products + whole.dot(drift_lost))
                .plus(rest.times(2.0 * roundoff))
                .plus(Pair::both(vanishes));
            let found = self.carried(k, rest, rest_lost)?;
            let [outer, _] = motions[parent].acceleration;
            lost[parent] = lost[parent]
                .plus(lost[k].at_distance(link.reach))
                .plus(outboard[k].lost.times(outer))
                .plus(Pair::new(errors(&found, 0..3), errors(&found, 3..6)));
            forces[parent] = forces[parent].plus(forces[k].at_distance(link.reach));
        }
        let links = links.iter().zip(lost).zip(beside);
        Ok(links
            .map(|((link, lost), beside)| TRUST * (link.along(lost) + beside))
            .collect())
    }
}

/// Magnitudes of a body's terms that its motion causes, and their errors.
#[derive(Clone, Copy)]
struct MotionSizes {
    /// Moment and force of the velocity terms.
    action: [Pair; 2],
    /// Acceleration of the velocity terms, without the joint's own.
    drift: [Pair; 2],
    acceleration: [Pair; 2],
}

impl MotionSizes {
    fn of(values: &[Value]) -> Self {
        let length =
            |of: fn(&Value) -> f64, first: usize| bound::root(values[first..][..3].iter().map(of));
        let pair = |of, first: usize| Pair::new(length(of, first), length(of, first + 3));
        let both = |first| {
            [
                pair(|value| value.reach(), first),
                pair(|value| value.error, first),
            ]
        };
        Self {
            action: both(0),
            drift: both(6),
            acceleration: both(12),
        }
    }
}
