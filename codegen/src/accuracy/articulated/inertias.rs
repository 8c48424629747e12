//! Errors of articulated inertias.
//!
//! In: the bodies as sizes, bounds of their motion, and the errors of each inertia on its way inwards.
//! Out: γ, s and the error of each body with all outboard of it, and the share of the robot's kinetic energy that
//! rounding may take. An error if rounding may make the sizes wrong on which everything else relies.

use std::f64::consts::SQRT_2;
use std::{cmp, ops};

use super::sizes::{LinkSizes, Pair};
use crate::accuracy::mobility::Mobility;
use crate::accuracy::solved::UNCERTAIN;
use crate::chain::BodyId;
use crate::list::List;
use crate::model::ARTICULATED_INERTIA;
use crate::real::Real;
use crate::schedule::bound::{self, Value};

/// ε: the largest share of a motion's energy that rounding may take.
pub(super) const SPOILT: f64 = 0.01;

/// Factor of the bounds that accounts for ε: sizes are those of exact articulated inertias.
pub(super) const TRUST: f64 = 1.06;

/// The largest ratio of the Frobenius norm of a 3×3 matrix to its spectral norm: √3.
pub(super) const FROBENIUS: f64 = 1.732_050_807_568_877_2;

/// Norms of the blocks A, B, M of an articulated inertia, or of its errors.
#[derive(Clone, Copy, Default)]
pub(super) struct Blocks {
    a: f64,
    b: f64,
    m: f64,
}

impl Blocks {
    /// Norms of the errors of an articulated inertia. Its entries are A and M as xx, yy, zz, xy, xz, yz, and B
    /// between them.
    fn of_errors(found: &[Value]) -> Self {
        // Entries off the diagonal of A and M occur twice.
        let symmetric = |at: usize| {
            bound::root([
                errors(found, at..at + 3),
                SQRT_2 * errors(found, at + 3..at + 6),
            ])
        };
        Self {
            a: symmetric(0),
            b: errors(found, 6..15),
            m: symmetric(15),
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            a: self.a + other.a,
            b: self.b + other.b,
            m: self.m + other.m,
        }
    }

    /// Moment and force for an acceleration.
    pub(super) fn times(self, acceleration: Pair) -> Pair {
        Pair::new(
            Pair::new(self.a, self.b).dot(acceleration),
            Pair::new(self.b, self.m).dot(acceleration),
        )
    }

    /// κ: the largest ratio to the blocks that γ and s allow.
    fn share(self, Pair { angular, linear }: Pair) -> f64 {
        let shares = [
            self.a / (angular * angular),
            self.b / (angular * linear),
            self.m / (linear * linear),
        ];
        // NaN counts as infinite.
        shares.into_iter().fold(0.0, |most, share| {
            if share.is_nan() {
                f64::INFINITY
            } else {
                share.max(most)
            }
        })
    }
}

/// A body with all bodies outboard of it.
#[derive(Clone, Copy, Default)]
pub(super) struct Outboard {
    /// γ and s.
    pub(super) whole: Pair,
    /// Number of its child bodies.
    pub(super) children: f64,
    /// Error of the inertia that it passes on, in the frame of the parent body.
    pub(super) lost: Blocks,
}

/// Sizes and errors of every body with all outboard of it, and the largest share of a motion's energy that rounding
/// may take. `step` computes the articulated inertia that one body passes on, with its errors, in the frame of its
/// parent.
///
/// # Errors
/// If rounding may take more than [`SPOILT`] of the energy.
pub(super) fn outboard(
    links: &List<BodyId, LinkSizes>,
    mobility: &Mobility,
    scalar: Real,
    step: impl Fn(BodyId, &[Value]) -> Result<Vec<Value>, &'static str>,
) -> Result<(List<BodyId, Outboard>, f64), &'static str> {
    let mut all = List::filled(Outboard::default(), links.len());
    let mut squares = List::filled(Pair::default(), links.len());
    // Sums of the errors that the child bodies have passed on.
    let mut received = List::filled(Blocks::default(), links.len());
    let mut spoilt = 0.0;
    for (k, link) in links.numbered().rev() {
        let whole = squares[k].plus(Pair::new(link.spread, link.mass)).roots();
        all[k].whole = whole;
        let children = all[k].children;
        if children > 0.0 {
            let [rotations, translations] = mobility.bodies[k].map(f64::sqrt);
            let speed = whole.dot(Pair::new(rotations, translations));
            let rounded = scalar.roundoff() * (3.0 + FROBENIUS * children);
            spoilt += (received[k].share(whole) + rounded) * speed * speed;
        }
        if let Some(parent) = link.parent {
            let passed = Blocks::of_errors(&step(k, &left(whole, scalar))?);
            all[k].lost = passed;
            received[parent] = received[parent].plus(passed);
            squares[parent] = squares[parent].plus(whole.at_distance(link.reach).squares());
            all[parent].children += 1.0;
        }
    }
    // NaN is refused as well.
    if spoilt.partial_cmp(&SPOILT).is_none_or(cmp::Ordering::is_gt) {
        return Err(UNCERTAIN);
    }
    Ok((all, spoilt))
}

/// The articulated inertia of sizes γ and s after its joint's part has been subtracted, with four roundings.
fn left(Pair { angular, linear }: Pair, scalar: Real) -> [Value; ARTICULATED_INERTIA] {
    let within = |size: f64| {
        let lost = 4.0 * (scalar.roundoff() * size + scalar.smallest());
        around_zero(size, lost)
    };
    std::array::from_fn(|entry| match entry {
        0..6 => within(angular * angular),
        6..15 => within(angular * linear),
        _ => within(linear * linear),
    })
}

/// The Euclidean norm of some errors.
pub(super) fn errors(found: &[Value], of: ops::Range<usize>) -> f64 {
    bound::root(found[of].iter().map(|value| value.error))
}

/// An unknown value of at most a size, with an error.
pub(super) fn around_zero(size: f64, error: f64) -> Value {
    Value {
        error,
        ..Value::between(-size, size)
    }
}
