//! The recursion over the bodies of a chain, one step inwards at a time.
//!
//! In: a chain, in the layout and by the algorithm of the function; the type of numbers. Out: the programs of its
//! steps, the bodies as sizes, and the errors of the results of a step.

use std::rc::Rc;

use super::inertias::{Outboard, around_zero, outboard};
use super::sizes::{LinkSizes, Pair};
use crate::accuracy::error_bounds::{RoundingModel, value, values};
use crate::accuracy::free_fall::FreeFall;
use crate::accuracy::mobility::{Mobility, mobility};
use crate::accuracy::solved::largest;
use crate::chain::{BodyId, Chain};
use crate::expression::Input;
use crate::layout::Layout;
use crate::list::List;
use crate::model::{ARTICULATED_INERTIA, Algorithm};
use crate::plan::{Programs, Recursion, arranged};
use crate::range::Range;
use crate::real::Real;
use crate::schedule::Program;
use crate::schedule::bound::{self, Conditions, Value};

/// The bodies of a chain, and the steps of the recursion over them.
pub struct Articulated<'c> {
    pub(super) chain: &'c Chain,
    pub(super) range: Range,
    pub(super) mobility: Mobility,
    pub(super) links: List<BodyId, LinkSizes>,
    pub(super) programs: Recursion,
    /// The fall of a floating base, to which the accelerations of the recursion are relative.
    pub(super) fall: Rc<Program>,
}

impl<'c> Articulated<'c> {
    /// The recursion of a function in a layout, by an algorithm.
    ///
    /// # Errors
    /// The reason why it has no bound.
    pub fn of(
        programs: &Programs<'c>,
        layout: Layout,
        algorithm: Algorithm,
    ) -> Result<Self, &'static str> {
        let chain = programs.chain();
        if !chain.all_lead() {
            return Err("none is derived of articulated bodies that follow others");
        }
        let range = Range::of(chain);
        let mobility = mobility(chain, layout, &range)?;
        let graph = chain.graph.clone();
        let bodies = arranged(&graph, chain, layout);
        let links = bodies.bodies.iter().map(|body| LinkSizes::of(body, &range));
        let links: Option<List<BodyId, LinkSizes>> = links.collect();
        let read = chain.nominal.iter().all(Vec::is_empty);
        let (Some(links), true) = (links, read) else {
            return Err("neither screws nor fields nor inertias that no body has are followed");
        };
        Ok(Self {
            chain,
            range,
            mobility,
            links,
            programs: programs.recursion(layout, algorithm, entry),
            fall: programs.free_fall(layout),
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
pub(super) struct RoundedRecursion<'a, 'c> {
    pub(super) bodies: &'a Articulated<'c>,
    pub(super) rounding: RoundingModel,
    pub(super) scalar: Real,
    pub(super) outboard: List<BodyId, Outboard>,
    pub(super) fall: FreeFall,
    /// The range, with accelerations relative to the fall.
    pub(super) range: Range,
    /// The largest share of a motion's energy that rounding may take.
    pub(super) spoilt: f64,
}

impl<'a, 'c> RoundedRecursion<'a, 'c> {
    /// The recursion in numbers of a type.
    ///
    /// # Errors
    /// If rounding may take too much of articulated inertias.
    pub(super) fn of(
        bodies: &'a Articulated<'c>,
        rounding: RoundingModel,
        scalar: Real,
    ) -> Result<Self, &'static str> {
        let Articulated {
            links,
            mobility,
            programs,
            range,
            ..
        } = bodies;
        let fall = FreeFall::of(&bodies.fall, range, rounding, scalar)?;
        let (outboard, spoilt) = outboard(links, mobility, scalar, |k, given| {
            follow(&programs.inertias[k], 0, given, bodies, rounding, scalar)
        })?;
        Ok(Self {
            bodies,
            rounding,
            scalar,
            outboard,
            range: fall.relative(range),
            fall,
            spoilt,
        })
    }

    /// A bound of √Mₖₖ for each velocity.
    pub(super) fn roots_of_masses(&self) -> Vec<f64> {
        let bodies = self.bodies.links.iter().zip(&self.outboard);
        bodies.map(|(link, body)| link.share(body.whole)).collect()
    }

    /// A wrench of a given size and error, after its step to the frame of the parent body.
    pub(super) fn carried(
        &self,
        k: BodyId,
        size: Pair,
        lost: Pair,
    ) -> Result<Vec<Value>, &'static str> {
        let action: [Value; 6] = std::array::from_fn(|entry| match entry {
            0..3 => around_zero(size.angular, lost.angular),
            _ => around_zero(size.linear, lost.linear),
        });
        let step = &self.bodies.programs.actions[k];
        let first = ARTICULATED_INERTIA;
        follow(
            step,
            first,
            &action,
            self.bodies,
            self.rounding,
            self.scalar,
        )
    }

    /// The largest square root of an inertia, at least 1.
    pub(super) fn inertia(&self) -> f64 {
        let armatures = self.bodies.links.iter().map(|link| link.armature.sqrt());
        let bodies = self.outboard.iter().map(|body| body.whole.largest());
        largest(bodies.chain(armatures))
    }

    /// A bound of all 1/D, at least 1.
    pub(super) fn mobility(&self) -> f64 {
        largest(self.bodies.mobility.joints.iter().map(|most| 2.0 * most))
    }
}

/// The results of a step for given entries, which are numbered from `first`.
fn follow(
    step: &Program,
    first: usize,
    given: &[Value],
    bodies: &Articulated<'_>,
    rounding: RoundingModel,
    scalar: Real,
) -> Result<Vec<Value>, &'static str> {
    let input = |input: Input| match input {
        Input::Parameter(0, k) => given[usize::from(k) - first],
        other => value(&bodies.range, other, scalar),
    };
    let conditions = Conditions {
        scalar,
        angles: rounding.trigonometry.reach(scalar),
        range: &input,
        quaternions: &bodies.range.quaternions,
    };
    values(bound::results(step, &conditions))
}

/// An entry of a step, as a field: the chain has none of its own.
fn entry(k: usize) -> Input {
    Input::Parameter(0, u16::try_from(k).expect("there are few"))
}
