//! Directions for the differentiation of functions.
//!
//! In: a chain, its graph, and one of its velocities. Out: the change of each coordinate along it, for
//! [`expression::along`](crate::expression::along).

use std::collections::BTreeMap;

use crate::chain::{Chain, Position};
use crate::expression::{Graph, Input, Term};
use crate::list::Id;
use crate::space::{CoordinateId, Variable, VelocityId};

/// The derivatives of the coordinates if one velocity is 1 and the others are zero: a column of N in q̇ = N v. Missing
/// coordinates do not change.
#[must_use]
pub fn coordinate_rates<'g>(
    graph: &'g Graph,
    chain: &Chain,
    velocity: VelocityId,
) -> BTreeMap<Input, Term<'g>> {
    let input = |coordinate: CoordinateId| {
        let k = u16::try_from(coordinate.index()).expect("fewer than 65536 coordinates");
        Input::Variable(Variable::Q, k)
    };
    let mover = chain.mover(velocity);
    // The first body of a joint without axes of its own has all coordinates.
    let first = chain.joints.ids().take(mover.index() + 1).rev();
    let mut first =
        first.skip_while(|&body| matches!(chain.joints[body].position, Position::Taken));
    let first = first
        .next()
        .expect("the first body of a joint is not taken");
    match chain.joints[first].position {
        Position::Manifold(manifold, start) => {
            let q = |k: usize| graph.input(input(start.plus(k)));
            let rates = manifold.rates(mover.index() - first.index(), q).into_iter();
            let coordinates = (0..).map(|k| input(start.plus(k)));
            coordinates.zip(rates).collect()
        }
        Position::Along { coordinate, .. } => {
            BTreeMap::from([(input(coordinate), graph.constant(1.0))])
        }
        Position::Taken => unreachable!("skipped above"),
    }
}
