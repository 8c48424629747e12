//! Error bounds of the inverse of the mass matrix by articulated bodies, from unit forces on their way inwards.
//!
//! In: the recursion in a type of numbers. Out: the error of entries of M⁻¹, in relation to the roots of the
//! diagonal entries of their row and column.

use std::cmp;

use super::Articulated;
use super::inertias::{SPOILT, TRUST, errors};
use super::recursion::RoundedRecursion;
use super::sizes::Pair;
use crate::accuracy::error_bounds::{Accuracy, RoundingModel, Worst, beside_diagonal};
use crate::accuracy::solved::{UNCERTAIN, underflow};
use crate::list::List;

impl Articulated<'_> {
    /// Bounds the inverse of the mass matrix, and its product with a column.
    #[must_use]
    pub fn inverse(&self, rounding: RoundingModel) -> Accuracy {
        beside_diagonal(self.chain, &self.steps(), rounding, |scalar| {
            RoundedRecursion::of(self, rounding, scalar)?.shares()
        })
    }
}

impl RoundedRecursion<'_, '_> {
    /// For each row the largest error of an entry, in units of √((M⁻¹)ᵢᵢ (M⁻¹)ⱼⱼ).
    fn shares(&self) -> Worst {
        let Articulated {
            links, mobility, ..
        } = self.bodies;
        let (inertia, mobility_bound) = (self.inertia(), self.mobility());
        // (M⁻¹)ⱼⱼ is at least 1/Mⱼⱼ, and the underflow is here in units of its root.
        let size = inertia * mobility_bound * (inertia * mobility_bound);
        // Reported last: a size that rounding leaves without bound may overflow as well.
        let underflows = underflow(size, links.len(), self.scalar);
        let vanishes = underflows.unwrap_or(0.0) * 2.0 * inertia * inertia;
        let roundoff = self.scalar.roundoff();

        // The error of the wrench that each joint passes on, as a share of the energy.
        let mut shares = List::filled(0.0, links.len());
        // The error of a wrench that has arrived at a body, by the worst path.
        let mut lost = List::filled(Pair::default(), links.len());
        for (k, link) in links.numbered().rev() {
            let Some(parent) = link.parent else {
                continue;
            };
            let whole = self.outboard[k].whole;
            let pushed = whole.times(6.0 * roundoff).plus(Pair::both(vanishes));
            let found = self.carried(k, whole, pushed)?;
            let own = Pair::new(errors(&found, 0..3), errors(&found, 3..6));
            let [rotations, translations] = mobility.bodies[parent].map(f64::sqrt);
            shares[k] = own.dot(Pair::new(rotations, translations));
            let arrived = lost[k].at_distance(link.reach).plus(own);
            let most = self.outboard[parent].whole.times(SPOILT);
            if !(is_within(arrived.angular, most.angular) && is_within(arrived.linear, most.linear))
            {
                return Err(UNCERTAIN);
            }
            lost[parent] = lost[parent].most(arrived);
        }
        // The error of each joint's unit force, on its whole path to the base.
        let mut losses = List::new();
        for (k, link) in links.numbered() {
            let before = link.parent.map_or(0.0, |parent| losses[parent]);
            losses.push(before + shares[k]);
        }
        let longest = losses.iter().copied().fold(0.0, f64::max);
        if !is_within(longest, SPOILT) {
            return Err(UNCERTAIN);
        }
        let count: f64 = links.iter().map(|_| 1.0).sum();
        let products = (2.0 * count + 6.0) * roundoff + vanishes;
        let row = |own| TRUST * (self.spoilt + own + longest + products);
        underflows.map(|_| losses.into_iter().map(row).collect())
    }
}

/// `found <= most`; false for NaN.
fn is_within(found: f64, most: f64) -> bool {
    found.partial_cmp(&most).is_some_and(cmp::Ordering::is_le)
}
