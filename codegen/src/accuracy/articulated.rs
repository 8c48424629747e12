//! What is solved exactly by the articulated-body recursion.
//!
//! In: a chain, in the layout and the way of the function. Out: how far the torques and forces that
//! its accelerations are exact for are from those given (backward error). It follows neither
//! screws nor numbers that are known at run time only. Every constant is derived below.
//!
#![doc = include_str!("articulated.md")]

mod inertias;
mod sizes;
#[cfg(test)]
mod tests;

use self::inertias::{FROBENIUS, Outboard, TRUST, around_zero, errors, outboard};
use self::sizes::{Link, Pair};
use super::promise::{Accuracy, Means, Perturbed, Worst, backward, computed, error, value};
use super::solved::{DOUBTFUL, caused, stays, tried, underflow, widened};
use crate::accuracy::mobility::{Mobility, mobility};
use crate::accuracy::range::Range;
use crate::chain::{BodyId, Chain};
use crate::expression::{Expr, Graph, Input, Term};
use crate::layout::{Layout, arrange};
use crate::list::List;
use crate::model::{self, ARTICULATED_INERTIA, ARTICULATED_MOTION, Way};
use crate::real::Real;
use crate::schedule::bound::{self, Conditions, Value};
use crate::schedule::{Program, schedule};
use crate::simplify::simplify;

/// The least margin that is tried: a thousandth of a bound is less than another attempt is worth.
const LEAST_MARGIN: f64 = 1e-3;

/// Of accelerations by articulated bodies.
#[must_use]
pub fn of_articulated(chain: &Chain, layout: Layout, way: Way, means: Means) -> Accuracy {
    if !chain.all_lead() {
        return Accuracy::Unknown("none is derived of articulated bodies that follow others");
    }
    let range = Range::of(chain);
    let mobility = match mobility(chain, layout, &range) {
        Ok(mobility) => mobility,
        Err(reason) => return Accuracy::Unknown(reason),
    };
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, layout);
    let links = bodies.bodies.iter().map(|body| Link::of(body, &range));
    let links: Option<List<BodyId, Link>> = links.collect();
    let read = chain.nominal.iter().all(Vec::is_empty);
    let (Some(links), true) = (links, read) else {
        return Accuracy::Unknown(
            "neither screws nor fields nor inertias that no body has are followed",
        );
    };
    let compiled = |results: &[Term<'_>]| -> Program {
        let results: Vec<Expr> = results.iter().map(|result| result.expr()).collect();
        let (graph, results): (Graph, Vec<Expr>) = simplify(&graph, &results);
        schedule(&graph, &results)
    };
    let motion = compiled(&model::articulated_motion(&graph, &bodies, way));
    let entries = std::array::from_fn(|k| graph.input(entry(k)));
    let steps = model::articulated_steps(&graph, &bodies, way, &entries).into_iter();
    let (inertias, actions): (List<BodyId, Program>, List<BodyId, Program>) = steps
        .map(|step| {
            let (inertia, action) = step.split_at(ARTICULATED_INERTIA);
            (compiled(inertia), compiled(action))
        })
        .unzip();
    let worst = |scalar: Real| -> Worst {
        let passed = |step: &Program, first: usize, given: &[Value]| {
            let input = |input: Input| match input {
                Input::Parameter(0, k) => given[usize::from(k) - first],
                other => value(&range, other, scalar),
            };
            let conditions = Conditions {
                scalar,
                angles: means.trigonometry.reach(scalar),
                range: &input,
            };
            values(bound::results(step, &conditions))
        };
        let outboard = outboard(&links, &mobility, scalar, |k, given| {
            passed(&inertias[k], 0, given)
        })?;
        let attempt = |margin: f64| -> Worst {
            let wider = widened(&range, margin);
            let found = values(computed(&motion, &wider, means, scalar))?;
            let motions = found.chunks(ARTICULATED_MOTION).map(Moving::of);
            let motions: List<BodyId, Moving> = motions.collect();
            let size = size(&links, &outboard, &motions, &wider, &mobility);
            let vanishes = underflow(size, links.len(), scalar)?;
            let errors = torque_errors(
                &links,
                &outboard,
                &motions,
                &wider,
                (scalar.roundoff(), vanishes),
                |k, given| passed(&actions[k], ARTICULATED_INERTIA, given),
            )?;
            let off = caused(&mobility.joints, &errors);
            if stays(&range, margin, &off) {
                Ok(errors)
            } else {
                Err(DOUBTFUL)
            }
        };
        tried(LEAST_MARGIN, attempt)
    };
    backward(chain, Perturbed::Torques, &[&motion], means, worst)
}

/// The place of an entry of a step among the fields, of which the chain has none.
fn entry(k: usize) -> Input {
    Input::Parameter(0, u16::try_from(k).expect("there are few"))
}

/// All that a program gives, or why one of it has no bound.
fn values(found: Vec<bound::Found>) -> Result<Vec<Value>, &'static str> {
    let found = found.into_iter();
    found
        .map(|found| error(found).map(|_| found.value))
        .collect()
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

/// The entries of an action: so large and with such errors.
fn action(size: Pair, lost: Pair) -> [Value; 6] {
    std::array::from_fn(|entry| match entry {
        0..3 => around_zero(size.turning, lost.turning),
        _ => around_zero(size.sliding, lost.sliding),
    })
}

/// A bound of every product on the way, as far as sizes of factors tell.
fn size(
    links: &[Link],
    outboard: &[Outboard],
    motions: &[Moving],
    range: &Range,
    mobility: &Mobility,
) -> f64 {
    let largest = |sizes: &mut dyn Iterator<Item = f64>| sizes.fold(1.0, f64::max);
    let inertia = largest(&mut outboard.iter().map(|body| body.whole.largest()));
    let inertia = largest(&mut links.iter().map(|link| link.armature.sqrt())).max(inertia);
    let moving = largest(&mut motions.iter().flat_map(|motion| {
        let parts = [motion.action, motion.drift, motion.acceleration];
        parts.map(|[size, _]| size.largest())
    }));
    let most = largest(&mut range.qdd.iter().map(|[_, most]| *most));
    // At least 1/D.
    let yielding = largest(&mut mobility.joints.iter().map(|most| 2.0 * most));
    inertia * inertia * moving * most * yielding
}

/// How far off the torque or force is that each joint feels, by all roundings; `step` computes what is
/// passed on beside the inertia, with its errors.
fn torque_errors(
    links: &List<BodyId, Link>,
    outboard: &List<BodyId, Outboard>,
    motions: &List<BodyId, Moving>,
    range: &Range,
    (roundoff, vanishes): (f64, f64),
    step: impl Fn(BodyId, &[Value]) -> Result<Vec<Value>, &'static str>,
) -> Worst {
    // Of each body and all outboard of it, the moment and force that they take, and what of them is
    // lost; as far as known from the bodies that hang on it.
    let mut forces = List::filled(Pair::default(), links.len());
    let mut lost = forces.clone();
    // What the joint alone feels besides.
    let mut beside = List::filled(0.0, links.len());
    for (k, link) in links.numbered().rev() {
        let Moving {
            action: [action_size, action_lost],
            drift: [drift, drift_lost],
            acceleration: [acceleration, acceleration_lost],
        } = motions[k];
        let Outboard {
            whole, children, ..
        } = outboard[k];
        let own = Pair::new(link.spread, link.mass).roots();
        let [_, most] = range.qdd[link.velocity];
        let opposed = whole.dot(acceleration);
        let free = opposed + most * link.share(whole);
        // |y|/√D: an armature opposes the joint's own acceleration.
        let lacking = opposed + most * link.armature.sqrt();
        let by_own = own.times(own.dot(acceleration));
        forces[k] = forces[k].plus(action_size).plus(by_own);

        // Of the joint's own equation, in units of √D.
        let driven = link.armature > 0.0;
        let roundings = if driven { 14.0 } else { 12.0 };
        let residual = roundings * roundoff * free + whole.dot(acceleration_lost);
        beside[k] = (link.share(whole) - link.along(whole)) * residual;
        let resistance = link.resistance(range.qd[link.velocity]);
        if resistance > 0.0 {
            let given = link.along(forces[k]) + link.armature * most;
            beside[k] += roundoff * (3.0 * resistance + given) + vanishes;
        }

        // The body's own; sums with what hangs on it; the joint's acceleration.
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
        // What is passed on: of the drift, of the joint's push, and their sum with the rest.
        let drifting = whole.dot(drift);
        let rest = forces[k].plus(whole.times(opposed + lacking + drifting));
        // A joint clears one column, but for an armature.
        let entries = if driven { 7.0 } else { 6.0 };
        let products = roundoff * ((entries * FROBENIUS + 3.0) * drifting + 4.0 * lacking);
        let rest_lost = whole
            .times(products + whole.dot(drift_lost))
            .plus(rest.times(2.0 * roundoff))
            .plus(Pair::both(vanishes));
        let found = step(k, &action(rest, rest_lost))?;
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
