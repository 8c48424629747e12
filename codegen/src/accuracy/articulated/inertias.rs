//! How well articulated inertias are known.
//!
//! In: the bodies as sizes, how much they can move, and the errors of each inertia on its way inwards.
//! Out: γ, s and what is lost, of each body and all outboard of it, and of the robot's energy; or that rounding
//! may spoil the sizes that everything else is counted by. It never looks at an acceleration.

use std::f64::consts::SQRT_2;
use std::{cmp, ops};

use super::sizes::{Link, Pair};
use crate::accuracy::mobility::Mobility;
use crate::accuracy::solved::DOUBTFUL;
use crate::chain::BodyId;
use crate::list::List;
use crate::model::ARTICULATED_INERTIA;
use crate::real::Real;
use crate::schedule::bound::{self, Value};

/// ε: how much of a motion's energy rounding may take.
pub(super) const SPOILT: f64 = 0.01;

/// What the bounds are multiplied by for it: sizes are those of exact articulated inertias.
pub(super) const TRUST: f64 = 1.06;

/// What Frobenius' norm of a 3×3 matrix is at most, beside the spectral one: √3.
pub(super) const FROBENIUS: f64 = 1.732_050_807_568_877_2;

/// Norms of the blocks A, B, M of an articulated inertia, or of its errors.
#[derive(Clone, Copy, Default)]
pub(super) struct Blocks {
    a: f64,
    b: f64,
    m: f64,
}

impl Blocks {
    /// Of the errors of an articulated inertia whose entries are A and M as xx, yy, zz, xy, xz, yz, and B
    /// between them.
    fn of_errors(found: &[Value]) -> Self {
        // Entries off the diagonal of A and M stand there twice.
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

    /// κ: the greatest share that they are of those that γ and s allow.
    fn share(self, Pair { turning, sliding }: Pair) -> f64 {
        let shares = [
            self.a / (turning * turning),
            self.b / (turning * sliding),
            self.m / (sliding * sliding),
        ];
        // What is not a number is no share that could be trusted.
        shares.into_iter().fold(0.0, |most, share| {
            if share.is_nan() {
                f64::INFINITY
            } else {
                share.max(most)
            }
        })
    }
}

/// A body and all that hangs on it.
#[derive(Clone, Copy, Default)]
pub(super) struct Outboard {
    /// γ and s.
    pub(super) whole: Pair,
    /// How many bodies hang on it directly.
    pub(super) children: f64,
    /// What is lost of the inertia that it passes on, in the frame of the body that carries it.
    pub(super) lost: Blocks,
}

/// Every body with all that hangs on it, and how much of a motion's energy rounding may take at most, where
/// articulated inertias keep enough digits for the sizes that they are taken to have; `step` computes one of them
/// in the frame of the carrying body, with its errors.
pub(super) fn outboard(
    links: &List<BodyId, Link>,
    mobility: &Mobility,
    scalar: Real,
    step: impl Fn(BodyId, &[Value]) -> Result<Vec<Value>, &'static str>,
) -> Result<(List<BodyId, Outboard>, f64), &'static str> {
    let mut all = List::filled(Outboard::default(), links.len());
    let mut squares = List::filled(Pair::default(), links.len());
    // Of what the bodies that hang on it have passed on.
    let mut received = List::filled(Blocks::default(), links.len());
    let mut spoilt = 0.0;
    for (k, link) in links.numbered().rev() {
        let whole = squares[k].plus(Pair::new(link.spread, link.mass)).roots();
        all[k].whole = whole;
        let children = all[k].children;
        if children > 0.0 {
            let [turns, slides] = mobility.bodies[k].map(f64::sqrt);
            let speed = whole.dot(Pair::new(turns, slides));
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
    // What is not a number is not less than anything.
    if spoilt.partial_cmp(&SPOILT).is_none_or(cmp::Ordering::is_gt) {
        return Err(DOUBTFUL);
    }
    Ok((all, spoilt))
}

/// What a joint leaves of the articulated inertia of γ and s, by four roundings.
fn left(Pair { turning, sliding }: Pair, scalar: Real) -> [Value; ARTICULATED_INERTIA] {
    let within = |size: f64| {
        let lost = 4.0 * (scalar.roundoff() * size + scalar.smallest());
        around_zero(size, lost)
    };
    std::array::from_fn(|entry| match entry {
        0..6 => within(turning * turning),
        6..15 => within(turning * sliding),
        _ => within(sliding * sliding),
    })
}

/// The length of some errors.
pub(super) fn errors(found: &[Value], of: ops::Range<usize>) -> f64 {
    bound::root(found[of].iter().map(|value| value.error))
}

/// Anything of a size, with an error.
pub(super) fn around_zero(size: f64, error: f64) -> Value {
    Value {
        error,
        ..Value::between(-size, size)
    }
}
