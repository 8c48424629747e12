//! The inverse of the mass matrix by articulated bodies: what unit forces do on their way inwards.
//!
//! In: the recursion in numbers of a type. Out: how far entries of M⁻¹ are from exact ones, in relation to the
//! roots of the diagonal ones of their row and column. It looks at no motion.

use std::cmp;

use super::Articulated;
use super::inertias::{SPOILT, TRUST, errors};
use super::recursion::Steps;
use super::sizes::Pair;
use crate::accuracy::promise::{Accuracy, Means, Worst, beside_diagonal};
use crate::accuracy::solved::{DOUBTFUL, underflow};
use crate::list::List;

impl Articulated<'_> {
    /// What is promised of the inverse of the mass matrix, and of its product with a column.
    #[must_use]
    pub fn inverse(&self, means: Means) -> Accuracy {
        beside_diagonal(self.chain, &self.steps(), means, |scalar| {
            Steps::of(self, means, scalar)?.shares()
        })
    }
}

impl Steps<'_, '_> {
    /// For each row the most that an entry is off, in units of √((M⁻¹)ᵢᵢ (M⁻¹)ⱼⱼ).
    fn shares(&self) -> Worst {
        let Articulated {
            links, mobility, ..
        } = self.bodies;
        let (inertia, yielding) = (self.inertia(), self.yielding());
        // (M⁻¹)ⱼⱼ is at least 1/Mⱼⱼ, and what vanishes is in units of its root here.
        let size = inertia * yielding * (inertia * yielding);
        // Told last: what may be anything for rounding may overflow as well.
        let underflows = underflow(size, links.len(), self.scalar);
        let vanishes = underflows.unwrap_or(0.0) * 2.0 * inertia * inertia;
        let roundoff = self.scalar.roundoff();

        // What each joint passes on loses by itself, as a share of the energy.
        let mut shares = List::filled(0.0, links.len());
        // What has been lost of an action until it is at a body, by the worst way there.
        let mut lost = List::filled(Pair::default(), links.len());
        for (k, link) in links.numbered().rev() {
            let Some(parent) = link.parent else {
                continue;
            };
            let whole = self.outboard[k].whole;
            let pushed = whole.times(6.0 * roundoff).plus(Pair::both(vanishes));
            let found = self.carried(k, whole, pushed)?;
            let own = Pair::new(errors(&found, 0..3), errors(&found, 3..6));
            let [turns, slides] = mobility.bodies[parent].map(f64::sqrt);
            shares[k] = own.dot(Pair::new(turns, slides));
            let arrived = lost[k].at_distance(link.reach).plus(own);
            let most = self.outboard[parent].whole.times(SPOILT);
            if !(is_within(arrived.turning, most.turning)
                && is_within(arrived.sliding, most.sliding))
            {
                return Err(DOUBTFUL);
            }
            lost[parent] = lost[parent].most(arrived);
        }
        // Of each joint's unit force, on its whole way.
        let mut ways = List::new();
        for (k, link) in links.numbered() {
            let before = link.parent.map_or(0.0, |parent| ways[parent]);
            ways.push(before + shares[k]);
        }
        let longest = ways.iter().copied().fold(0.0, f64::max);
        if !is_within(longest, SPOILT) {
            return Err(DOUBTFUL);
        }
        let count: f64 = links.iter().map(|_| 1.0).sum();
        let products = (2.0 * count + 6.0) * roundoff + vanishes;
        let row = |own| TRUST * (self.spoilt + own + longest + products);
        underflows.map(|_| ways.into_iter().map(row).collect())
    }
}

/// Whether a number is no more than another: what is no number is not.
fn is_within(found: f64, most: f64) -> bool {
    found.partial_cmp(&most).is_some_and(cmp::Ordering::is_le)
}
