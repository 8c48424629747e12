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
use crate::expression::Input;
use crate::layout::{Layout, arrange};
use crate::list::List;
use crate::model::{ARTICULATED_INERTIA, Way};
use crate::plan::{Programs, Recursion};
use crate::range::Range;
use crate::real::Real;
use crate::schedule::Program;
use crate::schedule::bound::{self, Conditions, Value};

/// The bodies of a chain, and the steps of the recursion over them.
pub struct Articulated<'c> {
    pub(super) chain: &'c Chain,
    pub(super) range: Range,
    pub(super) mobility: Mobility,
    pub(super) links: List<BodyId, Link>,
    pub(super) programs: Recursion,
}

impl<'c> Articulated<'c> {
    /// The recursion of a function in a layout and a way.
    ///
    /// # Errors
    /// Why it is not followed.
    pub fn of(programs: &Programs<'c>, layout: Layout, way: Way) -> Result<Self, &'static str> {
        let chain = programs.chain();
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
        Ok(Self {
            chain,
            range,
            mobility,
            links,
            programs: programs.recursion(layout, way, entry),
        })
    }

    /// The programs of all steps.
    pub(super) fn steps(&self) -> Vec<&Program> {
        let Recursion {
            inertias, actions, ..
        } = &self.programs;
        inertias.iter().chain(actions).collect()
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
            programs,
            ..
        } = bodies;
        let (outboard, spoilt) = outboard(links, mobility, scalar, |k, given| {
            follow(&programs.inertias[k], 0, given, bodies, means, scalar)
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
        let step = &self.bodies.programs.actions[k];
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
