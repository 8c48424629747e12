//! The recursion over the bodies of a chain, as it is followed: one step inwards at a time.
//!
//! In: a chain, in the layout and the way of the function; the numbers that it is computed in. Out: the
//! programs of its steps, the bodies as sizes, and what a step makes of errors. It sums nothing up.

use super::inertias::{Outboard, around_zero, outboard};
use super::sizes::{Link, Pair};
use crate::accuracy::mobility::{Mobility, mobility};
use crate::accuracy::promise::{Means, error, value};
use crate::accuracy::solved::largest;
use crate::chain::{BodyId, Chain};
use crate::expression::{Expr, Graph, Input, Term};
use crate::layout::{Layout, arrange};
use crate::list::List;
use crate::model::{self, ARTICULATED_INERTIA, Way};
use crate::range::Range;
use crate::real::Real;
use crate::schedule::bound::{self, Conditions, Value};
use crate::schedule::{Program, schedule};
use crate::simplify::simplify;

/// The bodies of a chain, and the steps of the recursion over them.
pub struct Articulated<'c> {
    pub(super) chain: &'c Chain,
    pub(super) range: Range,
    pub(super) mobility: Mobility,
    pub(super) links: List<BodyId, Link>,
    /// What velocities and given accelerations make of the bodies.
    pub(super) motion: Program,
    /// What becomes of an inertia on the way from each body to the one that carries it, and of an action.
    inertias: List<BodyId, Program>,
    actions: List<BodyId, Program>,
}

impl<'c> Articulated<'c> {
    /// The recursion of a function.
    ///
    /// # Errors
    /// Why it is not followed.
    pub fn of(chain: &'c Chain, layout: Layout, way: Way) -> Result<Self, &'static str> {
        if !chain.all_lead() {
            return Err("none is derived of articulated bodies that follow others");
        }
        let range = Range::of(chain);
        let mobility = mobility(chain, layout, &range)?;
        let graph = chain.graph.clone();
        let bodies = arrange(&graph, chain, layout);
        let links = bodies.bodies.iter().map(|body| Link::of(body, &range));
        let links: Option<List<BodyId, Link>> = links.collect();
        let read = chain.nominal.iter().all(Vec::is_empty);
        let (Some(links), true) = (links, read) else {
            return Err("neither screws nor fields nor inertias that no body has are followed");
        };
        let compiled = |results: &[Term<'_>]| -> Program {
            let results: Vec<Expr> = results.iter().map(|result| result.expr()).collect();
            let (graph, results): (Graph, Vec<Expr>) = simplify(&graph, &results);
            schedule(&graph, &results)
        };
        let motion = compiled(&model::articulated_motion(&graph, &bodies, way));
        let entries = std::array::from_fn(|k| graph.input(entry(k)));
        let steps = model::articulated_steps(&graph, &bodies, way, &entries).into_iter();
        let (inertias, actions) = steps
            .map(|step| {
                let (inertia, action) = step.split_at(ARTICULATED_INERTIA);
                (compiled(inertia), compiled(action))
            })
            .unzip();
        Ok(Self {
            chain,
            range,
            mobility,
            links,
            motion,
            inertias,
            actions,
        })
    }

    /// The programs of all steps.
    pub(super) fn steps(&self) -> Vec<&Program> {
        self.inertias.iter().chain(&self.actions).collect()
    }
}

/// The recursion in numbers of a type.
pub(super) struct Steps<'a, 'c> {
    pub(super) bodies: &'a Articulated<'c>,
    pub(super) means: Means,
    pub(super) scalar: Real,
    pub(super) outboard: List<BodyId, Outboard>,
    /// How much of a motion's energy rounding may take at most.
    pub(super) spoilt: f64,
}

impl<'a, 'c> Steps<'a, 'c> {
    /// Where articulated inertias keep enough digits.
    pub(super) fn of(
        bodies: &'a Articulated<'c>,
        means: Means,
        scalar: Real,
    ) -> Result<Self, &'static str> {
        let Articulated {
            links,
            mobility,
            inertias,
            ..
        } = bodies;
        let (outboard, spoilt) = outboard(links, mobility, scalar, |k, given| {
            follow(&inertias[k], 0, given, bodies, means, scalar)
        })?;
        Ok(Self {
            bodies,
            means,
            scalar,
            outboard,
            spoilt,
        })
    }

    /// An action of a size, so much of which is lost, in the frame of the body that carries this one.
    pub(super) fn carried(
        &self,
        k: BodyId,
        size: Pair,
        lost: Pair,
    ) -> Result<Vec<Value>, &'static str> {
        let action: [Value; 6] = std::array::from_fn(|entry| match entry {
            0..3 => around_zero(size.turning, lost.turning),
            _ => around_zero(size.sliding, lost.sliding),
        });
        let step = &self.bodies.actions[k];
        let first = ARTICULATED_INERTIA;
        follow(step, first, &action, self.bodies, self.means, self.scalar)
    }

    /// The greatest root of an inertia, or 1.
    pub(super) fn inertia(&self) -> f64 {
        let drives = self.bodies.links.iter().map(|link| link.armature.sqrt());
        let bodies = self.outboard.iter().map(|body| body.whole.largest());
        largest(bodies.chain(drives))
    }

    /// At least 1/D, and 1.
    pub(super) fn yielding(&self) -> f64 {
        largest(self.bodies.mobility.joints.iter().map(|most| 2.0 * most))
    }
}

/// What a step makes of the entries from the first.
fn follow(
    step: &Program,
    first: usize,
    given: &[Value],
    bodies: &Articulated<'_>,
    means: Means,
    scalar: Real,
) -> Result<Vec<Value>, &'static str> {
    let input = |input: Input| match input {
        Input::Parameter(0, k) => given[usize::from(k) - first],
        other => value(&bodies.range, other, scalar),
    };
    let conditions = Conditions {
        scalar,
        angles: means.trigonometry.reach(scalar),
        range: &input,
        quaternions: &bodies.range.quaternions,
    };
    values(bound::results(step, &conditions))
}

/// The place of an entry of a step among the fields, of which the chain has none.
fn entry(k: usize) -> Input {
    Input::Parameter(0, u16::try_from(k).expect("there are few"))
}

/// All that a program gives, or why one of it has no bound.
pub(super) fn values(found: Vec<bound::Found>) -> Result<Vec<Value>, &'static str> {
    let found = found.into_iter();
    found
        .map(|found| error(found).map(|_| found.value))
        .collect()
}
