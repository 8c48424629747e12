//! Bodies and motions as sizes: an angular and a linear part.
//!
//! In: the bodies of a chain. Out: a [`LinkSizes`] of each, and the arithmetic of [`Pair`]. Sizes hold in every
//! configuration.

use crate::accuracy::mobility::reach;
use crate::chain::BodyId;
use crate::expression::{Double, Term};
use crate::layout::Body;
use crate::range::Range;
use crate::schedule::bound;
use crate::space::VelocityId;

/// A body and its joint.
pub(super) struct LinkSizes {
    pub(super) parent: Option<BodyId>,
    pub(super) velocity: VelocityId,
    translates: bool,
    /// Largest distance of its origin from that of its parent body \[m\].
    pub(super) reach: f64,
    /// ∫r²dm about its origin \[kg m²\].
    pub(super) spread: f64,
    pub(super) mass: f64,
    /// Reflected inertia of the joint's actuator \[kg m², kg\].
    pub(super) armature: f64,
    pub(super) damping: f64,
    pub(super) friction: f64,
}

impl LinkSizes {
    /// `None` if the inertia is not physical, or for a screw joint.
    pub(super) fn of(body: &Body<'_>, range: &Range) -> Option<Self> {
        let number = |term: Term<'_>| term.value().map(Double::to_f64);
        let reach = reach(body, range);
        let [xx, yy, zz, ..] = body.inertia.second.0.map(number);
        let [armature, damping, friction] = body.actuator.map(number).entries();
        Some(Self {
            parent: body.parent,
            velocity: body.velocity,
            translates: body.motion.translates(),
            reach: reach.is_finite().then_some(reach)?,
            spread: spread([xx?, yy?, zz?])?,
            mass: number(body.inertia.mass)?.max(0.0),
            armature: armature?,
            damping: damping?,
            friction: friction?,
        })
    }
}

/// ∫r²dm from its three parts. `None` if one of them is negative by more than files round, which makes the inertia
/// non-physical.
fn spread(second: [f64; 3]) -> Option<f64> {
    /// The magnitude of a negative part that counts as rounding, in relation to the whole.
    const ROUNDED: f64 = 1e-6;
    let whole: f64 = second.iter().map(|part| part.abs()).sum();
    let negative = second.iter().any(|&part| part < -ROUNDED * whole);
    (!negative).then_some(whole * (1.0 + 3.0 * ROUNDED))
}

impl LinkSizes {
    /// The largest damping and friction torque for velocities in a range.
    pub(super) fn resistance(&self, [least, most]: [f64; 2]) -> f64 {
        self.damping * least.abs().max(most.abs()) + self.friction
    }

    /// A bound of √D, for γ and s.
    pub(super) fn share(&self, whole: Pair) -> f64 {
        bound::root([self.along(whole), self.armature.sqrt()])
    }

    /// The part of a moment and force, or of γ and s, along the joint's axis.
    pub(super) const fn along(&self, pair: Pair) -> f64 {
        if self.translates {
            pair.linear
        } else {
            pair.angular
        }
    }
}

/// An angular and a linear part: moment and force, ω̇ and a, γ and s.
#[derive(Clone, Copy, Default)]
pub(super) struct Pair {
    pub(super) angular: f64,
    pub(super) linear: f64,
}

impl Pair {
    pub(super) fn new(angular: f64, linear: f64) -> Self {
        Self { angular, linear }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self::new(self.angular + other.angular, self.linear + other.linear)
    }

    pub(super) fn times(self, factor: f64) -> Self {
        Self::new(self.angular * factor, self.linear * factor)
    }

    pub(super) fn dot(self, other: Self) -> f64 {
        self.angular * other.angular + self.linear * other.linear
    }

    pub(super) fn both(size: f64) -> Self {
        Self::new(size, size)
    }

    pub(super) fn squares(self) -> Self {
        Self::new(self.angular * self.angular, self.linear * self.linear)
    }

    pub(super) fn roots(self) -> Self {
        Self::new(self.angular.sqrt(), self.linear.sqrt())
    }

    pub(super) fn largest(self) -> f64 {
        self.angular.max(self.linear)
    }

    /// The larger one of each part.
    pub(super) fn most(self, other: Self) -> Self {
        Self::new(
            self.angular.max(other.angular),
            self.linear.max(other.linear),
        )
    }

    /// A moment and force, or γ and s, about a reference point at a distance.
    pub(super) fn at_distance(self, distance: f64) -> Self {
        Self::new(self.angular + distance * self.linear, self.linear)
    }
}
