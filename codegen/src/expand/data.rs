//! The chain as numbers and sums of run-time parameters.
//!
//! In: a chain. Out: the [`ChainData`] that the generic recursions of the runtime read.

use crate::chain::{BodyId, Chain, Frame, Joint, Position};
use crate::expression::{Double, Expr, Term};
use crate::list::Id;
use crate::module::{ChainData, DataMotion, LoopData, LoopsData};
use crate::schedule::schedule;

/// The chain as data: one joint for a ball, planar or floating joint, and otherwise one for each coordinate.
pub(super) fn data(chain: &Chain) -> ChainData {
    let narrow = |k: usize| u16::try_from(k).expect("fewer than 65536 joints");
    // For each body, the number of its joint.
    let mut count = 0;
    let places = chain.joints.map(|joint| {
        count += usize::from(!matches!(joint.position, Position::Taken));
        narrow(count - 1)
    });
    let mut joints: Vec<(&Joint, DataMotion)> = Vec::new();
    let mut inertias = Vec::new();
    for (k, joint) in chain.joints.numbered() {
        let mimicked = chain.mover(joint.velocity);
        let motion = match joint.position {
            Position::Along { .. } if mimicked == k => Some(DataMotion::Along),
            Position::Along { factor, .. } => Some(DataMotion::Mimic {
                mimicked: places[mimicked],
                multiplier: chain.graph.value(factor).map_or(1.0, Double::to_f64),
            }),
            Position::Manifold(manifold, _) => Some(DataMotion::Manifold(manifold)),
            Position::Taken => None,
        };
        match (motion, inertias.last_mut()) {
            (None, Some(last)) => *last = joint.inertia,
            (motion, _) => {
                joints.extend(motion.map(|motion| (joint, motion)));
                inertias.push(joint.inertia);
            }
        }
    }
    let mut results: Vec<Expr> = Vec::new();
    for ((joint, _), inertia) in joints.iter().zip(&inertias) {
        results.extend(joint.placement.entries());
        results.extend(chain.screw(joint).map(Term::expr));
        results.extend(inertia.entries());
    }
    let frames = || chain.frames.iter().chain(&chain.external);
    for frame in frames() {
        results.extend(frame.placement.entries());
    }
    results.extend(chain.gravity.0);
    let mut actuators = Vec::new();
    for (k, joint) in chain.joints.numbered() {
        let of_joint = places[k];
        let before = places
            .iter()
            .take(k.index())
            .filter(|&&place| place == of_joint);
        let actuator = joint.actuator.entries();
        let is_zero = |entry: &Expr| chain.graph.term(*entry).is_zero();
        if !actuator.iter().all(is_zero) {
            results.extend(actuator);
            actuators.push((of_joint, narrow(before.count())));
        }
    }
    let place = |body: BodyId| places[body];
    let name = |(joint, motion): &(&Joint, DataMotion)| match motion {
        DataMotion::Manifold(_) => joint.of.clone(),
        DataMotion::Along | DataMotion::Mimic { .. } => joint.name.clone(),
    };
    ChainData {
        names: joints.iter().map(name).collect(),
        parents: (joints.iter())
            .map(|(joint, _)| joint.parent.map(place))
            .collect(),
        motions: joints.iter().map(|(_, motion)| *motion).collect(),
        frames: frames()
            .map(|frame| (frame.name.clone(), frame.body.map(place)))
            .collect(),
        external: (chain.external.len(), chain.request.external_in_frame_0),
        actuated: actuators,
        program: schedule(&chain.graph, &results),
        loops: loops(chain, place),
    }
}

/// The loops as data; `place` gives the joint of a body.
fn loops(chain: &Chain, place: impl Fn(BodyId) -> u16) -> LoopsData {
    let frame = |frame: &Frame| (frame.name.clone(), frame.body.map(&place));
    let loops = chain.loops.iter().map(|closed| LoopData {
        name: closed.name.clone(),
        frames: closed.frames.each_ref().map(frame),
        rows: closed.rows.clone(),
    });
    let numbers = chain.loops.iter().flat_map(|closed| {
        let placements = closed.frames.iter();
        let placements = placements.flat_map(|frame| frame.placement.entries());
        placements.chain([closed.size])
    });
    let numbers: Vec<Expr> = numbers.collect();
    LoopsData {
        loops: loops.collect(),
        actuated: chain.actuated.clone().into(),
        program: schedule(&chain.graph, &numbers),
    }
}
