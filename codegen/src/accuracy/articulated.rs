//! What is solved exactly by the articulated-body recursion.
//!
//! In: a chain, in the layout and the way of the function. Out: how far the torques and forces that
//! its accelerations are exact for are from those given (backward error). It follows neither
//! screws nor numbers that are known at run time only.
//!
//! Every step inwards passes on a force: what is articulated, times the acceleration that the body
//! comes to have, and the rest. A step that rounds passes on another one, and all joints inboard of
//! it feel the difference. What it can be follows from the bodies alone, for an articulated inertia
//! never opposes more to an acceleration than the bodies that it stands for would as one. So sizes
//! are of moments and forces as γ and s make them: γ² bounds ∫r²dm of all that is outboard, about the
//! origin of the body, and s² is its mass.

use std::f64::consts::SQRT_2;
use std::{cmp, ops};

use super::solved::{DOUBTFUL, caused, stays, tried, widened};
use super::{Accuracy, Given, Means, Worst, backward, computed, error, value};
use crate::accuracy::mobility::{Mobility, mobility};
use crate::accuracy::range::Range;
use crate::chain::{Chain, Motion};
use crate::expression::{Double, Expr, Graph, Input, Term};
use crate::layout::{Body, Layout, arrange};
use crate::model::{self, ARTICULATED_MOTION, ARTICULATED_STEP, Way};
use crate::real::Real;
use crate::schedule::bound::{self, Conditions, Value};
use crate::schedule::{Program, schedule};
use crate::simplify::simplify;

/// How much of a motion's energy rounding may take: what is opposed to it is then known well enough
/// for [`TRUST`].
const SPOILT: f64 = 0.05;

/// What the bounds are multiplied by for it: articulated inertias that are off by so much oppose
/// little more, and their pivots are little less.
const TRUST: f64 = 1.25;

/// Of accelerations by articulated bodies.
#[must_use]
pub fn of_articulated(chain: &Chain, layout: Layout, way: Way, means: Means) -> Accuracy {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, layout);
    let range = Range::of(chain);
    let links = bodies.bodies.iter().zip(&range.q);
    let links: Option<Vec<Link>> = links.map(|(body, q)| Link::of(body, *q)).collect();
    let read = chain.nominal.iter().all(Vec::is_empty);
    let (Some(links), true) = (links, read) else {
        return Accuracy::Unknown(
            "neither screws nor fields nor inertias that no body has are followed",
        );
    };
    let mobility = match mobility(chain, layout, &range) {
        Ok(mobility) => mobility,
        Err(reason) => return Accuracy::Unknown(reason),
    };
    let compiled = |results: Vec<Term<'_>>| -> Program {
        let results: Vec<Expr> = results.into_iter().map(Term::expr).collect();
        let (graph, results): (Graph, Vec<Expr>) = simplify(&graph, &results);
        schedule(&graph, &results)
    };
    let motion = compiled(model::articulated_motion(&graph, &bodies, way));
    let entries = std::array::from_fn(|k| graph.input(entry(k)));
    let steps = model::articulated_steps(&graph, &bodies, way, &entries);
    let steps: Vec<Program> = steps.into_iter().map(compiled).collect();
    let worst = |scalar: Real| -> Worst {
        let attempt = |margin: f64| -> Worst {
            let wider = widened(&range, margin);
            let found = computed(&motion, &wider, means, scalar).into_iter();
            let found = found.map(|found| error(found).map(|_| found.value));
            let found = found.collect::<Result<Vec<Value>, _>>()?;
            let motions: Vec<Moving> = found.chunks(ARTICULATED_MOTION).map(Moving::of).collect();
            let step = |k: usize, given: &[Value; ARTICULATED_STEP]| {
                let input = |input: Input| match input {
                    Input::Parameter(0, k) => given[usize::from(k)],
                    other => value(&range, other, scalar),
                };
                let conditions = Conditions {
                    scalar,
                    angles: means.trigonometry.reach(scalar),
                    range: &input,
                };
                let found = bound::results(&steps[k], &conditions).into_iter();
                let found = found.map(|found| error(found).map(|_| found.value));
                found.collect::<Result<Vec<Value>, _>>()
            };
            let errors = torque_errors(&links, &motions, &wider, &mobility, scalar, step)?;
            let off = caused(&mobility.joints, &errors);
            if stays(&range, margin, &off) {
                Ok(errors)
            } else {
                Err(DOUBTFUL)
            }
        };
        tried(attempt)
    };
    backward(chain, Given::Torques, &[&motion], means, worst)
}

/// The place of an entry of a step among the fields, of which the chain has none.
fn entry(k: usize) -> Input {
    Input::Parameter(0, u16::try_from(k).expect("there are few"))
}

/// A body and its joint.
struct Link {
    parent: Option<usize>,
    slides: bool,
    /// How far its origin can be from that of the body it hangs on.
    reach: f64,
    /// ∫r²dm about its origin.
    spread: f64,
    mass: f64,
}

impl Link {
    fn of(body: &Body<'_>, [lo, hi]: [f64; 2]) -> Option<Self> {
        let number = |term: Term<'_>| term.value().map(Double::to_f64);
        let slide = match body.motion {
            Motion::Revolute => 0.0,
            Motion::Prismatic => lo.abs().max(hi.abs()),
            Motion::Screw(_) => return None,
        };
        let [x, y, z] = body.placement.translation.0.map(number);
        let [xx, yy, zz, ..] = body.inertia.second.0.map(number);
        Some(Self {
            parent: body.parent,
            slides: matches!(body.motion, Motion::Prismatic),
            reach: slide + norm([x?, y?, z?]),
            spread: spread([xx?, yy?, zz?])?,
            mass: number(body.inertia.mass)?.max(0.0),
        })
    }
}

/// ∫r²dm of its three parts, of which none is negative but for the digits that files round; none for
/// what no body is.
fn spread(second: [f64; 3]) -> Option<f64> {
    /// What a part may be below zero, in relation to the whole.
    const ROUNDED: f64 = 1e-6;
    let whole: f64 = second.iter().map(|part| part.abs()).sum();
    let negative = second.iter().any(|&part| part < -ROUNDED * whole);
    (!negative).then_some(whole * (1.0 + 3.0 * ROUNDED))
}

impl Link {
    /// What its joint feels of moment and force, or of γ and s.
    const fn along(&self, pair: Pair) -> f64 {
        if self.slides {
            pair.sliding
        } else {
            pair.turning
        }
    }
}

/// Something about an axis and something along it: moment and force, ω̇ and a, γ and s.
#[derive(Clone, Copy, Default)]
struct Pair {
    turning: f64,
    sliding: f64,
}

impl Pair {
    fn new(turning: f64, sliding: f64) -> Self {
        Self { turning, sliding }
    }

    fn plus(self, other: Self) -> Self {
        Self::new(self.turning + other.turning, self.sliding + other.sliding)
    }

    fn times(self, factor: f64) -> Self {
        Self::new(self.turning * factor, self.sliding * factor)
    }

    fn dot(self, other: Self) -> f64 {
        self.turning * other.turning + self.sliding * other.sliding
    }

    fn squares(self) -> Self {
        Self::new(self.turning * self.turning, self.sliding * self.sliding)
    }

    fn roots(self) -> Self {
        Self::new(self.turning.sqrt(), self.sliding.sqrt())
    }

    /// A moment and a force at a distance from where they act.
    fn at_distance(self, distance: f64) -> Self {
        Self::new(self.turning + distance * self.sliding, self.sliding)
    }
}

/// The lengths of what a motion makes of a body, and their errors.
#[derive(Clone, Copy)]
struct Moving {
    /// Moment and force that its velocities take.
    action: [Pair; 2],
    /// What they add to its acceleration beyond its joint.
    drift: [Pair; 2],
    acceleration: [Pair; 2],
}

impl Moving {
    fn of(values: &[Value]) -> Self {
        let length =
            |of: fn(&Value) -> f64, first: usize| norm(values[first..][..3].iter().map(of));
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

/// How far off the torque or force is that each joint feels, by all roundings; `step` computes what a joint passes on, with its errors.
///
/// Roundings are counted where they are not followed step by step. A product with the reciprocal of a
/// pivot D has three; and since U = (c, f) of a unit acceleration of the joint has entries of at most
/// γ√D and s√D, D cancels wherever it divides.
fn torque_errors(
    links: &[Link],
    motions: &[Moving],
    range: &Range,
    mobility: &Mobility,
    scalar: Real,
    step: impl Fn(usize, &[Value; ARTICULATED_STEP]) -> Result<Vec<Value>, &'static str>,
) -> Worst {
    let roundoff = scalar.roundoff();
    let root_3 = 3.0_f64.sqrt();
    let none = || vec![Pair::default(); links.len()];
    // Of each body and all outboard of it: γ² and s², the moment and force that they take, and what of
    // them is lost; all as far as known from the bodies that hang on it, and how many there are.
    let (mut squares, mut forces, mut lost) = (none(), none(), none());
    let mut children = vec![0.0; links.len()];
    // Of the energy of a motion, what is lost of articulated inertias takes at most this share.
    let mut spoilt = 0.0;
    for (k, link) in links.iter().enumerate().rev() {
        let Moving {
            action: [action, action_lost],
            drift: [drift, drift_lost],
            acceleration: [acceleration, acceleration_lost],
        } = motions[k];
        let own = Pair::new(link.spread, link.mass);
        squares[k] = squares[k].plus(own);
        let (own, whole) = (own.roots(), squares[k].roots());
        let [_, most] = range.qdd[k];
        let opposed = whole.dot(acceleration);
        let free = opposed + most * link.along(whole);
        let by_own = own.times(own.dot(acceleration));
        forces[k] = forces[k].plus(action).plus(by_own);

        // The body's own action and inertia; sums with what hangs on it, entry by entry; the joint's
        // acceleration, by six products and six more roundings.
        let sums = whole.times((3.0 + root_3) * opposed);
        let sums = sums.plus(forces[k].times(root_3));
        lost[k] = lost[k]
            .plus(action_lost)
            .plus(by_own.times(3.0 * roundoff))
            .plus(sums.times(children[k] * roundoff))
            .plus(whole.times(12.0 * roundoff * free + whole.dot(acceleration_lost)));

        let Some(parent) = link.parent else {
            continue;
        };
        // What is passed on beside the inertia: the rest, that of the drift, by six products each, and
        // that of the joint, by three; and their sum.
        let drifting = whole.dot(drift);
        let rest = forces[k].plus(whole.times(opposed + drifting + 2.0 * free));
        let products = roundoff * 6.0 * (root_3 * drifting + free);
        let rest_lost = whole.times(products + whole.dot(drift_lost));
        let rest_lost = rest_lost.plus(rest.times(2.0 * roundoff));
        let found = step(k, &passed_on(whole, [rest, rest_lost], scalar))?;
        let [outer, _] = motions[parent].acceleration;
        let seen = Pair::new(whole.turning + link.reach * whole.sliding, whole.sliding);
        let [turns, slides] = mobility.bodies[parent].map(f64::sqrt);
        let moving = Pair::new(turns, slides);
        let speed = seen.dot(moving);
        let summed = speed * speed * (3.0 + children[parent]) * roundoff;
        spoilt += inertia_of(&found, moving).dot(moving) + summed;
        lost[parent] = lost[parent]
            .plus(lost[k].at_distance(link.reach))
            .plus(error_of(&found, outer));
        forces[parent] = forces[parent].plus(forces[k].at_distance(link.reach));
        squares[parent] = squares[parent].plus(seen.squares());
        children[parent] += 1.0;
    }
    // What is not a number is not less than anything.
    if spoilt.partial_cmp(&SPOILT).is_none_or(cmp::Ordering::is_gt) {
        return Err(DOUBTFUL);
    }
    let links = links.iter().zip(lost);
    Ok(links.map(|(link, lost)| TRUST * link.along(lost)).collect())
}

/// What a step takes: what the joint leaves of the articulated inertia of γ and s, by four roundings,
/// and the rest with its error.
fn passed_on(whole: Pair, [rest, lost]: [Pair; 2], scalar: Real) -> [Value; ARTICULATED_STEP] {
    let within = |size: f64, error: f64| Value {
        error,
        ..Value::between(-size, size)
    };
    let inertia = |size: f64| {
        let lost = 4.0 * (scalar.roundoff() * size + scalar.smallest());
        within(size, lost)
    };
    std::array::from_fn(|entry| match entry {
        0..6 => inertia(whole.turning * whole.turning),
        6..15 => inertia(whole.turning * whole.sliding),
        15..21 => inertia(whole.sliding * whole.sliding),
        21..24 => within(rest.turning, lost.turning),
        _ => within(rest.sliding, lost.sliding),
    })
}

/// Moment and force of the errors of what a step gives, where the outer body accelerates so much.
fn error_of(found: &[Value], outer: Pair) -> Pair {
    inertia_of(found, outer).plus(Pair::new(lost(found, 21..24), lost(found, 24..27)))
}

/// Those of the errors of its articulated inertia alone.
fn inertia_of(found: &[Value], outer: Pair) -> Pair {
    // Entries off the diagonal of A and M stand there twice.
    let symmetric = |at: usize| {
        norm([
            lost(found, at..at + 3),
            SQRT_2 * lost(found, at + 3..at + 6),
        ])
    };
    let (a, b, m) = (symmetric(0), lost(found, 6..15), symmetric(15));
    Pair::new(Pair::new(a, b).dot(outer), Pair::new(b, m).dot(outer))
}

/// The length of some errors.
fn lost(found: &[Value], of: ops::Range<usize>) -> f64 {
    norm(found[of].iter().map(|value| value.error))
}

/// √Σx², of a sum that neither overflows nor vanishes; the `hypot` of each platform is its own.
fn norm(entries: impl IntoIterator<Item = f64>) -> f64 {
    bound::root(entries)
}
