//! The chain as numbers, and sums of run-time parameters.
//!
//! In: a chain. Out: the [`ChainData`] that the generic recursions of the runtime read. It never
//! sees a function.

use crate::chain::Chain;
use crate::expression::{Expr, Term};
use crate::print::ChainData;
use crate::schedule::schedule;

/// The chain as data.
pub(super) fn data(chain: &Chain) -> ChainData {
    let narrow = |k: usize| u16::try_from(k).expect("fewer than 65536 joints");
    let mut results: Vec<Expr> = Vec::new();
    for joint in &chain.joints {
        results.extend(joint.placement.entries());
        results.extend(chain.screw(joint).map(Term::expr));
        results.extend(joint.inertia.entries());
    }
    for frame in &chain.frames {
        results.extend(frame.placement.entries());
    }
    results.extend(chain.gravity.0);
    ChainData {
        names: chain
            .joints
            .iter()
            .map(|joint| joint.name.clone())
            .collect(),
        parents: chain
            .joints
            .iter()
            .map(|joint| joint.parent.map(narrow))
            .collect(),
        frames: chain
            .frames
            .iter()
            .map(|frame| (frame.name.clone(), frame.body.map(narrow)))
            .collect(),
        program: schedule(&chain.graph, &results),
    }
}
